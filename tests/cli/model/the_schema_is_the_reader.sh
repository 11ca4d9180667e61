# docs/cell.schema.json has the keys that the reader has, no more and no fewer; every cell of docs
# and examples fits it, and what the reader refuses it refuses.
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/></robot>
URDF
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >thing.obj
python3 - "$SRC" <<'PY'
import glob, json, re, subprocess, sys, tomllib
import jsonschema
source = sys.argv[1]
schema = json.load(open(source + '/docs/cell.schema.json'))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)

# Every table with a key that no reader knows: the fault lists those that it does.
odd = 'qqqqqqqqqqqqqqqq'
open('odd.cell.toml', 'w').write(f'''
format = 1
{odd} = 1
[[device]]
model = "arm.urdf"
{odd} = 1
pose = {{ {odd} = 1 }}
[[model]]
name = "m"
obj = "thing.obj"
unit = "m"
up = "z"
{odd} = 1
[[model.link]]
name = "l"
parent = "base"
{odd} = 1
joint = {{ name = "j", type = "revolute", axis = [1, 0, 0], {odd} = 1, mimic = {{ joint = "k", {odd} = 1 }} }}
[[camera]]
{odd} = 1
intrinsics = {{ {odd} = 1 }}
[[inset]]
{odd} = 1
[[layer]]
{odd} = 1
[[light]]
{odd} = 1
[[material]]
{odd} = 1
[[source]]
{odd} = 1
[scene]
{odd} = 1
''')
said = subprocess.run(['rocinante', 'model', 'info', 'odd.cell.toml', '--json'], capture_output=True, text=True)
keys = {}
for fault in json.loads(said.stdout)['faults']:
    if fault['rule'] == 'cell.unknown-key':
        keys[fault['text'].split(' has an')[0]] = set(fault['hint'].removeprefix('its keys are ').split(', '))
tables = schema['definitions']
expected = {'the cell': schema, '[[device]]': tables['device'], 'pose': tables['pose'],
            '[[model]]': tables['model'], '[[model.link]]': tables['link'], 'joint': tables['joint'],
            'mimic': tables['joint']['properties']['mimic'], '[[camera]]': tables['camera'],
            'intrinsics': tables['camera']['properties']['intrinsics'], '[[inset]]': tables['inset'],
            '[[layer]]': tables['layer'], '[[light]]': tables['light'], '[[material]]': tables['material'],
            '[[source]]': tables['source'], '[scene]': tables['scene']}
for table, of in expected.items():
    if keys.get(table) != set(of['properties']):
        print(table, 'differs:', sorted(keys.get(table, set()) ^ set(of['properties'])))

page = open(source + '/docs/cell-format.md', encoding='utf-8').read()
cells = re.findall(r'^```toml\n(.*?)^```', page, re.M | re.S)
for name in glob.glob(source + '/examples/**/*.cell.toml', recursive=True):
    cells.append(open(name, encoding='utf-8').read())
for cell in cells:
    for fault in validator.iter_errors(tomllib.loads(cell)):
        print(cell, fault.message)

head = 'format = 1\n'
for wrong in ['', 'format = 2', head + 'serach = []', head + '[[device]]\nname = "a"',
              head + '[[device]]\nmodel = "a.urdf"\ncolor = "red"', head + '[[device]]\nmodel = "a.urdf"\nname = "a/b"',
              head + '[[device]]\nmodel = "a.urdf"\npose = { rpy = [0, 0, 0], rpy_deg = [0, 0, 0] }',
              head + '[[model]]\nname = "a"', head + '[[model]]\nname = "a"\nobj = "a.obj"\nurdf = "a.urdf"',
              head + '[[camera]]\nname = "c"\neye = [0, 0]\ntarget = [0, 0, 0]', head + '[[material]]\nlink = "a"',
              head + '[[camera]]\nname = "c"\neye = [0, 0, 1]\ntarget = [0, 0, 0]\ndistortion = [0, 0, 0, 0]',
              head + '[[camera]]\nname = "c"\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nfov_deg = 40\n'
              'intrinsics = { fx = 9, fy = 9, cx = 4, cy = 3, width = 8, height = 6 }',
              head + '[[inset]]\ncamera = "map"\ncorner = "left"',
              head + '[[inset]]\ncamera = "map"\nsize = [2, 2]', head + '[[inset]]\nsize_px = [64, 64]',
              head + '[[source]]\nname = "s"\nrate_hz = [-1, 2]', head + '[rules]\n"packet.bad-name" = "loud"',
              head + '[rules]\n"joint.limit" = { "arm/a" = { rad_or_m = 0 } }', head + '[rules]\n"joint.limit" = { "arm/a" = [1] }',
              head + '[[layer]]\nname = "l"\nopacity = 2', head + '[[layer]]\nname = "l"\ncollision = "in"', head + '[[light]]\nname = "l"',
              head + '[[light]]\nname = "l"\ndirection = [0, 0, 1]\nstrength = -1']:
    open('wrong.cell.toml', 'w').write(wrong)
    status = subprocess.run(['rocinante', 'model', 'tree', 'wrong.cell.toml', '--strict'], capture_output=True).returncode
    if status == 0 or validator.is_valid(tomllib.loads(wrong)):
        print('taken:', wrong, status)
print(len(expected), 'tables;', 'cells of docs and examples fit' if len(cells) > 5 else 'no cells')
PY
