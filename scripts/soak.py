"""A long batch with an eye on its heap: see soak."""

import argparse
import os
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import small_movies

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MOVIES, KEPT, PAUSE = 20, 50, 60
# What the heap may grow by between two thirds of the time: the list of what was done is kept.
MOST_GROWTH_MB, BYTES_A_ROW = 3, 4000


def java(pid):
    """-> the process that is Java itself, of a script that may have started it"""
    with open('/proc/%d/comm' % pid) as f:
        if f.read().strip() == 'java':
            return pid
    children = subprocess.run(['ps', '-o', 'pid=', '--ppid', str(pid)], capture_output=True, text=True).stdout.split()
    return java(int(children[0])) if children else None


def heap(pid):
    """-> MB of the heap that are in use after a collection"""
    for command in ('GC.run', 'GC.heap_info'):
        text = subprocess.run(['jcmd', str(pid), command], capture_output=True, text=True).stdout
    return sum(int(k) for k in re.findall(r'(?:generation|heap) +total \d+K, used (\d+)K', text)) / 1024


def done(out):
    path = os.path.join(out, 'batch.csv')
    if not os.path.exists(path):
        return 0, 0
    with open(path, encoding='utf-8') as f:
        text = f.read()
    return text.count(',finished,'), text.count(',failed,')


def tidy(out):
    """Old results go, so that the disk is not filled"""
    folders = [e for e in os.scandir(out) if e.is_dir() and not e.name.startswith('.') and e.name.startswith('m')]
    for entry in sorted(folders, key=lambda e: e.stat().st_mtime)[:-KEPT]:
        shutil.rmtree(entry.path, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(prog='scripts/soak', description=(
        'Runs one batch for a long time and looks what is left in the heap after collections: it must stay flat.'))
    parser.add_argument('--minutes', type=float, default=30, help='how long [30]')
    parser.add_argument('--options', default='--no-plots', help='options for all movies [--no-plots]')
    parser.add_argument('--program', default=shlex.quote(os.path.join(ROOT, 'scripts', 'knotresolver')),
                        help='the command line [scripts/knotresolver]')
    options = parser.parse_args()
    if options.minutes < 5:
        parser.error('--minutes must be at least 5, but is %g' % options.minutes)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        movies, out, sheet = (os.path.join(home, n) for n in ('movies', 'out', 'sheet.csv'))
        small_movies.make(movies, MOVIES)
        with open(sheet, 'w', encoding='utf-8') as f:
            f.write('FileName,FolderPath\n')
            # More than can be done in that time.
            f.writelines('m%04d.tif,movies\n' % (i % MOVIES) for i in range(int(options.minutes * 600)))
        command = shlex.split(options.program) + ['batch', sheet, '--out', out] + options.options.split()
        environment = {**os.environ, 'JAVA_OPTS': '-XX:+UseSerialGC -Xmx512m'}
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment)
        start, seen = time.time(), []
        print('| minute | rows done | failed | heap after a collection, MB |\n|---|---|---|---|', flush=True)
        while time.time() - start < options.minutes * 60:
            time.sleep(PAUSE)
            if process.poll() is not None:
                sys.exit('The batch ended by itself: ' + process.stderr.read().decode()[-500:])
            used, (rows, failed) = heap(java(process.pid)), done(out)
            seen.append((rows, used))
            print('| %.0f | %d | %d | %.1f |' % ((time.time() - start) / 60, rows, failed, used), flush=True)
            tidy(out)
            if failed:
                sys.exit('A row failed; the rows are all alike.')
        process.terminate()
        process.wait()
        third = len(seen) // 3
        middle, last = seen[third:2 * third], seen[2 * third:]
        growth = statistics.median(u for _, u in last) - statistics.median(u for _, u in middle)
        allowed = MOST_GROWTH_MB + BYTES_A_ROW * (last[-1][0] - middle[0][0]) / 2 ** 20
        print('From the second third to the last the heap grew by %.1f MB; allowed are %.1f.' % (growth, allowed))
        return 1 if growth > allowed else 0


if __name__ == '__main__':
    sys.exit(main())
