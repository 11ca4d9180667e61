# NumPy reads what `log table` writes, and it is what the CSV says.
# The first python3 may be another than Debian's.
for python in python3 /usr/bin/python3; do $python -c 'import numpy' 2>/dev/null && break; python=; done
[ -n "$python" ] || { echo "skipped: there is no python3-numpy"; exit 77; }
log="$SRC/examples/demo/session.mcap"
for ending in csv npy npz; do
  rocinante log table "$log" --cell "$SRC/examples/demo/demo.cell.toml" -o demo.$ending
done
$python - <<'PYTHON'
import csv, numpy
array, archive = numpy.load("demo.npy"), numpy.load("demo.npz")
rows = list(csv.reader(open("demo.csv")))
names = ["t", "t_ns"] + rows[0][1:]
assert list(array.dtype.names) == names == archive.files
for name in names:
    assert numpy.array_equal(array[name], archive[name], equal_nan=name != "t_ns"), name
columns = [[float(field) if field else numpy.nan for field in column] for column in zip(*rows[1:])]
for name, column in zip(rows[0], columns):
    assert numpy.array_equal(array[name], column, equal_nan=True), name
assert [round(t * 1e9) for t in columns[0]] == list(array["t_ns"])
print(len(array), "rows of", len(names), "columns are the same")
PYTHON
