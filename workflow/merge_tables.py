"""Puts a table of all results of a batch into one: python3 merge_tables.py BATCH.csv TABLE OUT.csv

The rows of OUT are those of RESULT/TABLE.csv for each row of BATCH.csv that has a result, in its order, with
the columns movie and result before them.
"""

import csv
import os
import sys


def rows(path):
    with open(path, encoding='utf-8', newline='') as f:
        yield from csv.DictReader(f)


def main(batch, table, out):
    folder = os.path.dirname(os.path.abspath(batch))
    merged, header = [], []
    for row in rows(batch):
        if not row['result']:
            continue
        for line in rows(os.path.join(folder, row['result'], table + '.csv')):
            # summary.csv has a column movie of its own: the file's name, where this one has its path.
            line = {'name' if k == 'movie' else k: v for k, v in line.items()}
            header += [k for k in line if k not in header]
            merged.append({'movie': row['movie'], 'result': row['result'], **line})
    with open(out, 'w', encoding='utf-8', newline='') as f:
        writer = csv.DictWriter(f, ['movie', 'result'] + header, lineterminator='\n')
        writer.writeheader()
        writer.writerows(merged)


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
