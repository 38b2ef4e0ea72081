"""Kills the program at random times and checks what it leaves: see kill-test."""

import argparse
import hashlib
import os
import random
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SAMPLE = os.path.join(ROOT, 'src/main/resources/io/github/knotresolver/sample/knotted-filament.tif')
OPTIONS = ['--frames', '1-3']
FOREIGN = {'corrections.csv': b'frame,index,x_px,y_px\n', 'notes/read me.txt': b'mine\n'}


def digest(folder):
    """-> {relative path: SHA-256} of all that can be seen in a folder"""
    found = {}
    for path, folders, files in os.walk(folder):
        folders[:] = [f for f in folders if not f.startswith('.')]
        for name in files:
            if not name.startswith('.'):
                full = os.path.join(path, name)
                with open(full, 'rb') as f:
                    found[os.path.relpath(full, folder)] = hashlib.sha256(f.read()).hexdigest()
    return found


def hidden(folder):
    return sorted(n for n in os.listdir(folder) if n.startswith('.')) if os.path.isdir(folder) else []


class Case:
    """One way of running the program into one place, again and again."""

    def __init__(self, name, program, home, arguments, out, foreign):
        self.name, self.home, self.out = name, home, out
        self.command = program + arguments
        self.foreign = foreign
        self.kills = self.complete = self.absent = self.between = 0
        self.faults = []

    def start(self):
        return subprocess.Popen(self.command, cwd=self.home, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                start_new_session=True)

    def finish(self):
        """Runs to the end; -> seconds"""
        start = time.time()
        process = self.start()
        err = process.communicate()[1].decode(errors='replace')
        if process.returncode != 0:
            self.faults.append('a run that was not killed ended with status %d: %s' % (process.returncode, err.strip()))
        return time.time() - start

    def prepare(self):
        """The undisturbed result, which every complete one must equal"""
        self.seconds = self.full = self.finish()
        self.ended = False
        self.reference = digest(self.out)
        self.add_foreign()
        self.inputs = {n: h for n, h in digest(self.home).items() if not self.is_output(n)}

    def is_output(self, name):
        return os.path.join(self.home, name).startswith(self.out + os.sep)

    def add_foreign(self):
        for name, content in self.foreign.items():
            path = os.path.join(self.out, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'wb') as f:
                f.write(content)

    def kill(self, after):
        process = self.start()
        start = time.time()
        while process.poll() is None and time.time() - start < after:
            time.sleep(0.005)
        ended = process.poll() is not None
        if ended:
            self.seconds = time.time() - start
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.communicate()
        self.kills += not ended
        self.ended = ended
        self.check('killed after %.2f s' % after)

    def check(self, when):
        found = digest(self.out) if os.path.isdir(self.out) else {}
        for name, content in self.foreign.items():
            if found.pop(name, None) != hashlib.sha256(content).hexdigest():
                self.faults.append(when + ': the foreign file ' + name + ' is touched')
        now = {n: h for n, h in digest(self.home).items() if not self.is_output(n)}
        if now != self.inputs:
            self.faults.append(when + ': input files are touched')
        self.judge(found, when)

    def judge(self, found, when):
        if found == self.reference:
            self.complete += 1
        elif not found:
            self.absent += 1
        elif self.foreign and 'parameters.json' not in found:
            # Said in the documentation: among foreign files, files come one by one.
            self.between += 1
        else:
            self.faults.append(when + ': half a result: ' + ', '.join(
                sorted(n for n in self.reference if found.get(n) != self.reference[n])))

    def end(self):
        """The next run completes and clears up"""
        self.finish()
        found = digest(self.out)
        for name in self.foreign:
            found.pop(name, None)
        if found != self.reference:
            self.faults.append('the last run did not complete the result')
        left = hidden(os.path.dirname(self.out)) + hidden(self.out)
        if left:
            self.faults.append('left behind: ' + ', '.join(left))


class BatchCase(Case):
    """Every result folder of a batch is judged by itself; the list is complete lines."""

    def judge(self, found, when):
        for movie in {n.split('/')[0] for n in self.reference if '/' in n}:
            mine = {n: h for n, h in found.items() if n.startswith(movie + '/')}
            wanted = {n: h for n, h in self.reference.items() if n.startswith(movie + '/')}
            if mine and mine != wanted:
                self.faults.append(when + ': half a result: ' + movie)
        path = os.path.join(self.out, 'batch.csv')
        if os.path.exists(path):
            with open(path, encoding='utf-8') as f:
                text = f.read()
            if not text.startswith('line,movie,status,result,message\n') or not text.endswith('\n'):
                self.faults.append(when + ': batch.csv is cut off')
        done = found.keys() == self.reference.keys()
        self.complete += done
        self.absent += not done

    def end(self):
        # List and page say 'skipped' where the undisturbed ones say 'finished'.
        strip = lambda d: {n: h for n, h in d.items() if n not in ('batch.csv', 'batch.html')}
        self.finish()
        if strip(digest(self.out)) != strip(self.reference):
            self.faults.append('the last run did not complete the results')
        left = hidden(self.out)
        if left:
            self.faults.append('left behind: ' + ', '.join(left))


def cases(program, home):
    for name in ('fresh', 'force', 'foreign', 'batch'):
        os.makedirs(os.path.join(home, name))
        for movie in ('a.tif', 'b.tif') if name == 'batch' else ('movie.tif',):
            shutil.copy(SAMPLE, os.path.join(home, name, movie))
    resolve = ['resolve', 'movie.tif', '--out', 'result', '--no-plots', '--force'] + OPTIONS
    at = lambda n: os.path.join(home, n)
    with open(os.path.join(home, 'batch', 'sheet.csv'), 'w', encoding='utf-8') as f:
        f.write('FileName,FolderPath\na.tif,.\nb.tif,.\n')
    return [Case('resolve into a new folder', program, at('fresh'), resolve, os.path.join(at('fresh'), 'result'), {}),
            Case('resolve --force over a result', program, at('force'), resolve, os.path.join(at('force'), 'result'), {}),
            Case('resolve --force among foreign files', program, at('foreign'), resolve,
                 os.path.join(at('foreign'), 'result'), FOREIGN),
            BatchCase('batch of two movies', program, at('batch'),
                      ['batch', 'sheet.csv', '--out', 'results', '--no-plots'] + OPTIONS,
                      os.path.join(at('batch'), 'results'), {})]


def main():
    parser = argparse.ArgumentParser(prog='scripts/kill-test', description=(
        'Kills resolve and batch at random times and checks that a result is complete or absent, that nothing of '
        'the user\'s is touched, and that the next run clears up and completes. Half of the kills fall into the '
        'last third of a run, when files are written.'))
    parser.add_argument('--kills', type=int, default=50, help='kills in all, shared by four cases [50]')
    parser.add_argument('--seed', type=int, default=1, help='start of the random numbers [1]')
    parser.add_argument('--program', default=shlex.quote(os.path.join(ROOT, 'scripts', 'knotresolver')),
                        help='the command to kill [scripts/knotresolver]')
    options = parser.parse_args()
    if options.kills < 4:
        parser.error('--kills must be at least 4, but is %d' % options.kills)
    chance = random.Random(options.seed)
    faults = 0
    with tempfile.TemporaryDirectory() as home:
        print('| case | kills | complete | absent | between | faults |\n|---|---|---|---|---|---|', flush=True)
        for i, case in enumerate(cases(shlex.split(options.program), home)):
            case.prepare()
            wanted = options.kills // 4 + (i < options.kills % 4)
            for k in range(10 * wanted):
                if case.kills == wanted:
                    break
                # A run that ended before it was killed counts as no kill; a batch is done then.
                if i == 0 or i == 3 and (k % 3 == 0 or case.ended):
                    shutil.rmtree(case.out, ignore_errors=True)
                    case.seconds = max(case.seconds, case.full)
                low, high = (0.67, 1) if k % 2 == 0 else (0.02, 0.67)
                case.kill(case.seconds * chance.uniform(low, high))
            case.end()
            print('| %s | %d | %d | %d | %d | %d |' % (case.name, case.kills, case.complete, case.absent, case.between,
                                                      len(case.faults)), flush=True)
            for fault in case.faults:
                print(case.name + ': ' + fault, file=sys.stderr)
            faults += len(case.faults)
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
