"""
Fits a logistic function with weights that are not negative to the table of
scripts/fit-confidence: movie, frame, right, confidence, figures. A movie is called
CONDITION_CURVES; conditions are sorted by name, and every other one is for learning.
Prints the weights as Java and a table of reliability on the other conditions.
"""
import csv
import sys

import numpy as np
from scipy.optimize import minimize

# Weight of the weights: keeps a figure that says little small.
RIDGE = 0.0005

# The least constant: a contour that nothing speaks against is believed.
LEAST_CONSTANT = 5

# Figures are cut off here, as FitEvidence does; a table may have been made before.
MOST = [1, 2, 1, .5, .25, .5, 1, 1, 1, 3, 1, 1, 1]


def read(path):
    with open(path, encoding='utf-8') as table:
        rows = list(csv.DictReader(table))
    names = list(rows[0])[4:]
    condition = np.array([r['movie'].split('_')[0] if not r['movie'].startswith(('static_', 'glide_c'))
                          else '_'.join(r['movie'].split('_')[:2]) for r in rows])
    figures = np.minimum(MOST, [[float(r[n]) for n in names] for r in rows])
    return names, condition, figures, np.array([r['right'] == '1' for r in rows]), rows


def fit(figures, right):
    """Constant and weights of least negative log likelihood; wrong frames weigh as much as right ones, at most tenfold."""
    wrong = max(1, (~right).sum())
    weight = np.where(right, 1.0, min(10.0, max(1.0, right.sum() / wrong)))
    sign = np.where(right, 1.0, -1.0)

    def price(p):
        logit = p[0] - figures @ p[1:]
        at = -sign * logit
        loss = np.logaddexp(0, at)
        slope = weight * -sign / (1 + np.exp(-at))
        n = weight.sum()
        return ((weight * loss).sum() / n + RIDGE * (p[1:] ** 2).sum() / len(p),
                np.r_[slope.sum() / n, -(figures.T @ slope) / n + 2 * RIDGE * p[1:] / len(p)])

    start = np.r_[5.0, np.ones(figures.shape[1])]
    found = minimize(price, start, jac=True, bounds=[(LEAST_CONSTANT, 9)] + [(0, 30)] * figures.shape[1])
    return found.x


def reliability(title, confidence, right, condition):
    print(f'\n{title}: {len(right)} frames, {100 * right.mean():.1f} % right')
    print('| confidence | frames | mean confidence | right |\n|---|---|---|---|')
    edges = [0, .1, .3, .5, .7, .9, .99, 1.0001]
    for low, high in zip(edges, edges[1:]):
        some = (confidence >= low) & (confidence < high)
        if some.any():
            print(f'| {low:.2f}-{min(1, high):.2f} | {some.sum()} | {confidence[some].mean():.3f} | {100 * right[some].mean():.1f} % |')
    sure = confidence > .9
    if sure.any():
        print(f'above 0.9: {100 * right[sure].mean():.2f} % right; silent {100 * (sure & ~right).mean():.2f} % of all; '
              f'right frames below 0.6: {100 * ((confidence < .6) & right).sum() / max(1, right.sum()):.1f} %')
    for name in np.unique(condition[sure & ~right]):
        some = condition == name
        print(f'  silent in {name}: {100 * (sure & ~right & some).sum() / some.sum():.1f} %')


def main():
    names, condition, figures, right, rows = read(sys.argv[1])
    kinds = sorted(set(condition))
    learning = np.isin(condition, kinds[::2])
    found = fit(figures[learning], right[learning])
    print('learned on', ' '.join(kinds[::2]))
    print('tested on', ' '.join(kinds[1::2]))
    print(f'constant {found[0]:.2f}')
    print('weights {' + ', '.join(f'{w:.2f}' for w in found[1:]) + '}  //', ','.join(names))
    confidence = 1 / (1 + np.exp(-(found[0] - figures @ found[1:])))
    reliability('Learning', confidence[learning], right[learning], condition[learning])
    reliability('Test', confidence[~learning], right[~learning], condition[~learning])
    now = np.array([float(r['confidence']) for r in rows])
    reliability('All, by the confidence in the table', now, right, condition)


if __name__ == '__main__':
    main()
