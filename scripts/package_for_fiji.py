"""Lays out the files of a release: see package-for-fiji."""

import hashlib
import json
import os
import re
import shutil
import sys
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TARGET = os.path.join(ROOT, 'target')
RELEASE = os.path.join(TARGET, 'release')
# Fijis were seen to have these, or what brings them along (docs/dependencies.md); a second version beside a Fiji's own
# would do harm.
FIJI_HAS = ('ij', 'imglib2', 'jgrapht-core', 'jheaps', 'apfloat', 'commons-math3', 'commons-io', 'commons-codec', 'gson',
            'jfreechart', 'picocli', 'scijava-common', 'parsington')


def name(jar):
    """imglib2-8.0.0.jar -> imglib2"""
    return re.sub(r'-[0-9][0-9A-Za-z.]*(-SNAPSHOT)?\.jar$', '', jar)


def plugin():
    jars = [j for j in os.listdir(TARGET) if j.startswith('KnotResolver_-') and j.endswith('.jar')
            and not re.search(r'-(sources|tests|javadoc)\.jar$', j)]
    if len(jars) != 1:
        sys.exit('There must be one jar of the plugin in target, but there are %d; run ./mvnw clean package.' % len(jars))
    return jars[0]


def files():
    """-> {place in Fiji: file}"""
    jar = plugin()
    found = {'plugins/' + jar: os.path.join(TARGET, jar)}
    for library in sorted(os.listdir(os.path.join(TARGET, 'lib'))):
        if name(library) not in FIJI_HAS:
            found['jars/' + library] = os.path.join(TARGET, 'lib', library)
    return found


def date():
    """-> the date of the release, of pom.xml, as a zip file has it"""
    with open(os.path.join(ROOT, 'pom.xml'), encoding='utf-8') as f:
        stamp = re.search(r'<project\.build\.outputTimestamp>(\d+)-(\d+)-(\d+)T(\d+):(\d+):(\d+)Z<', f.read())
    return tuple(map(int, stamp.groups()))


def sha256(path):
    with open(path, 'rb') as f:
        return hashlib.sha256(f.read()).hexdigest()


def check_bom(path, shipped):
    """Every library that is shipped must be on the list"""
    with open(path, encoding='utf-8') as f:
        bom = json.load(f)
    if bom.get('bomFormat') != 'CycloneDX':
        sys.exit(path + ' is no CycloneDX list.')
    listed = {'%s-%s.jar' % (c['name'], c['version']) for c in bom['components']}
    missing = [os.path.basename(p) for p in shipped if p.startswith('jars/') and os.path.basename(p) not in listed]
    if missing:
        sys.exit('sbom.json does not list ' + ', '.join(missing))
    nameless = [c['name'] for c in bom['components'] if not c.get('licenses')]
    if nameless:
        sys.exit('sbom.json has no licence for ' + ', '.join(nameless))


def main():
    shutil.rmtree(RELEASE, ignore_errors=True)
    site = os.path.join(RELEASE, 'update-site')
    shipped = files()
    for place, file in shipped.items():
        os.makedirs(os.path.dirname(os.path.join(site, place)), exist_ok=True)
        shutil.copyfile(file, os.path.join(site, place))
    version = re.search(r'KnotResolver_-(.*)\.jar', plugin()).group(1)
    shutil.copyfile(os.path.join(TARGET, 'sbom.json'), os.path.join(RELEASE, 'sbom.json'))
    check_bom(os.path.join(RELEASE, 'sbom.json'), shipped)
    shutil.copyfile(os.path.join(TARGET, 'licences', 'THIRD-PARTY.txt'), os.path.join(RELEASE, 'THIRD-PARTY.txt'))
    package = os.path.join(RELEASE, 'KnotResolver-%s-fiji.zip' % version)
    texts = {'licenses/KnotResolver/LICENSE': os.path.join(ROOT, 'LICENSE'),
             'licenses/KnotResolver/THIRD-PARTY.txt': os.path.join(RELEASE, 'THIRD-PARTY.txt'),
             'licenses/KnotResolver/sbom.json': os.path.join(RELEASE, 'sbom.json')}
    with zipfile.ZipFile(package, 'w', zipfile.ZIP_DEFLATED) as out:
        for place, file in sorted({**shipped, **texts}.items()):
            entry = zipfile.ZipInfo(place, date())
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            with open(file, 'rb') as f:
                out.writestr(entry, f.read())
    sums = ['%s  %s\n' % (sha256(os.path.join(RELEASE, n)), n) for n in sorted(os.listdir(RELEASE))
            if os.path.isfile(os.path.join(RELEASE, n))]
    with open(os.path.join(RELEASE, 'SHA256SUMS'), 'w', encoding='utf-8') as f:
        f.writelines(sums)
    for place in sorted(shipped):
        print(place)
    print('Release: ' + os.path.relpath(package, ROOT))


if __name__ == '__main__':
    main()
