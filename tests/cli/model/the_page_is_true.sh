# Every console example of docs/programs/model.md says what the page says; where the page stops in
# the middle, the rest is left out.
cp -r "$SRC/examples/demo" demo && cd demo
python3 - "$SRC/docs/programs/model.md" <<'PY'
import re, subprocess, sys
page = open(sys.argv[1], encoding='utf-8').read()
examples = re.findall(r'^```console\n\$ (.*)\n((?:.*\n)*?)```', page, re.M)
for command, expected in examples:
    command = command.replace('/tmp/', '')
    said = subprocess.run(['bash', '-c', command], capture_output=True, text=True)
    if not said.stdout.startswith(expected) or said.returncode:
        print(f'$ {command}\nthe page:\n{expected}it says:\n{said.stdout}{said.stderr}')
print(len(examples), 'examples')
PY
