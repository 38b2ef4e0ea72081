"""Many movies one by one, side by side and as jobs, undisturbed and killed: see many-test."""

import argparse
import csv
import hashlib
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import small_movies

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def digest(folder):
    """-> {file: SHA-256} of a result"""
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), 'rb') as f:
            found[name] = hashlib.sha256(f.read()).hexdigest()
    return found


def finished(out):
    """-> {name: {file: SHA-256}} of the results that are there"""
    names = sorted(os.listdir(out)) if os.path.isdir(out) else []
    return {n: digest(os.path.join(out, n)) for n in names
            if not n.startswith('.') and os.path.exists(os.path.join(out, n, 'parameters.json'))}


def statuses(out):
    with open(os.path.join(out, 'batch.csv'), encoding='utf-8', newline='') as f:
        return [row['status'] for row in csv.DictReader(f)]


class Way:
    """A way to resolve all movies: a command that is run, killed, and run again."""

    def __init__(self, name, command, out, log, environment=None):
        self.name, self.command, self.out = name, command, out
        self.log, self.environment = log, {**os.environ, **(environment or {})}

    def start(self):
        with open(self.log, 'ab') as log:
            return subprocess.Popen(self.command, stdout=log, stderr=log, start_new_session=True, env=self.environment)

    def run(self):
        """-> seconds"""
        start = time.time()
        status = self.start().wait()
        # 1 says that a movie has no result; whether it is the same ones is looked at.
        if status not in (0, 1):
            raise SystemExit('%s: ended with status %d; %s tells more' % (self.name, status, self.log))
        return time.time() - start

    def kill(self, wanted):
        """Kills it when so many results are there; -> those that were there"""
        process = self.start()
        while len(finished(self.out)) < wanted:
            if process.poll() is not None:
                raise SystemExit('%s: ended before it was killed; %s tells more' % (self.name, self.log))
            time.sleep(0.2)
        # The first one first, so that it starts no others; jobs of Snakemake have groups of their own.
        for pid in [process.pid] + descendants(process.pid):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        process.wait()
        time.sleep(1)
        return finished(self.out)


def descendants(pid):
    found = subprocess.run(['ps', '-o', 'pid=', '--ppid', str(pid)], capture_output=True, text=True).stdout.split()
    return [int(p) for p in found] + [q for p in found for q in descendants(int(p))]


def check(way, reference, faults):
    found = finished(way.out)
    different = sorted(n for n in reference if found.get(n) != reference[n])
    if different or found.keys() != reference.keys():
        faults.append('%s: %d results differ from those made one by one: %s' % (
            way.name, len(different), ', '.join(different[:5])))
    for page in ('batch.csv', 'batch.html'):
        if not os.path.exists(os.path.join(way.out, page)):
            faults.append(way.name + ': there is no ' + page)


def killed_and_again(way, reference, most_lost, unlock=None):
    """-> a row of the table"""
    faults = []
    before = way.kill(len(reference) // 2)
    times = {n: os.stat(os.path.join(way.out, n, 'parameters.json')).st_mtime_ns for n in before}
    for name in before:
        if before[name] != reference[name]:
            faults.append(way.name + ': half a result after the kill: ' + name)
    if unlock:
        subprocess.run(way.command + unlock, env=way.environment, capture_output=True)
    started = len([d for d in os.listdir(way.out) if '.partial-' in d])
    seconds = way.run()
    check(way, reference, faults)
    twice = sum(os.stat(os.path.join(way.out, n, 'parameters.json')).st_mtime_ns != t for n, t in times.items())
    if twice:
        faults.append('%s: %d finished results were done again' % (way.name, twice))
    if started > most_lost:
        faults.append('%s: %d movies were lost' % (way.name, started))
    left = [n for n in os.listdir(way.out) if '.partial-' in n]
    if left:
        faults.append('%s: left behind: %s' % (way.name, ', '.join(left)))
    report(way.name + ', killed after %d, and again' % len(before), len(reference), started, seconds, faults)
    return faults


def report(name, movies, lost, seconds, faults):
    print('| %s | %d | %s | %.0f | %d |' % (name, movies, lost, seconds, len(faults)), flush=True)
    for fault in faults:
        print(fault, file=sys.stderr)


def undisturbed(way, reference):
    faults = []
    seconds = way.run()
    check(way, reference, faults)
    report(way.name, len(reference), '', seconds, faults)
    return faults


def main():
    parser = argparse.ArgumentParser(prog='scripts/many-test', description=(
        'Resolves many small movies one by one, by one batch and by the workflow of Snakemake, and checks that all give '
        'the same bytes, also if batch or workflow are killed in the middle and run again.'))
    parser.add_argument('--movies', type=int, default=200, help='how many [200]')
    parser.add_argument('--batch-size', type=int, default=10, help='movies in a job of the workflow [10]')
    parser.add_argument('--options', default='--no-plots', help=(
        'options for all movies [--no-plots]; the published method is the quickest: '
        '"--no-plots --candidates paper --resolver paper --no-refine"'))
    parser.add_argument('--alone', type=int, default=1, metavar='K', help=(
        'one by one means a process for each K-th movie, and one batch of one movie at a time for the others [1]'))
    parser.add_argument('--only', choices=['batch', 'workflow'], help='one of the two ways [both]')
    parser.add_argument('--program', default=shlex.quote(os.path.join(ROOT, 'scripts', 'knotresolver')),
                        help='the command line [scripts/knotresolver]')
    options = parser.parse_args()
    if options.movies < 4:
        parser.error('--movies must be at least 4, but is %d' % options.movies)
    faults, told = [], options.options.split()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        at = lambda *names: os.path.join(home, *names)
        small_movies.make(at('movies'), options.movies)
        print('| way | movies | running when killed | s | faults |\n|---|---|---|---|---|', flush=True)
        program = shlex.split(options.program)
        start = time.time()
        subprocess.run(program + ['batch', at('movies'), '--out', at('single'), '--movies', '1', '--threads', '1']
                       + told, capture_output=True)
        for name in sorted(os.listdir(at('movies')))[::options.alone]:
            shutil.rmtree(at('single', name[:-4]), ignore_errors=True)
            subprocess.run(program + ['resolve', at('movies', name), '--out', at('single', name[:-4])] + told,
                           capture_output=True)
        reference = finished(at('single'))
        if len(reference) < options.movies / 2:
            raise SystemExit('Only %d of %d movies have a result; give other --options.' % (
                len(reference), options.movies))
        report('one by one', len(reference), '', time.time() - start, [])
        if options.only != 'workflow':
            batch = lambda out: Way('batch', program + ['batch', at('movies'), '--out', at(out)] + told, at(out),
                                    at(out + '.log'))
            faults += undisturbed(batch('batch'), reference)
            faults += killed_and_again(batch('batch-killed'), reference, os.cpu_count())
        if options.only != 'batch' and not shutil.which(os.environ.get('SNAKEMAKE', 'snakemake')):
            print('Snakemake was not found: the workflow is left out (pip install snakemake).', file=sys.stderr)
        elif options.only != 'batch':
            workflow = lambda out: Way('workflow', [
                os.path.join(ROOT, 'scripts', 'workflow'), at('movies'), '--out', at(out), '--batch-size',
                str(options.batch_size), '--options', ' '.join(told)], at(out), at(out + '.log'),
                {'KNOTRESOLVER': program[0]} if len(program) == 1 else {})
            planned = subprocess.run(workflow('workflow').command + ['--dry-run'], env=workflow('workflow').environment,
                                     capture_output=True, text=True)
            if planned.returncode != 0 or 'This was a dry-run' not in planned.stdout + planned.stderr:
                faults.append('workflow: the dry run failed: ' + planned.stderr[-500:])
            faults += undisturbed(workflow('workflow'), reference)
            faults += killed_and_again(workflow('workflow-killed'), reference, os.cpu_count(), ['--unlock'])
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
