# A report of CI is a stranger's file: 24,000 brackets in 48 kB once took 3.2 GB. It is refused for its depth, in little
# memory.
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
printf 'format = 1\ncell = "box.urdf"\n[defaults]\nsize = [64, 48]\nsamples = 1\n[[case]]\nname = "a"\n' >suite.toml
rocinante golden run suite.toml --report report >/dev/null || echo "exit $?"
printf 'a\t%032d\n' 0 >list.txt
python3 -c 'print("[" * 24000 + "]" * 24000)' >report/report.json
python3 - <<'PY'
import resource, subprocess
ended = subprocess.run(["rocinante", "golden", "approve", "suite.toml", "--artifact", "report", "--from", "list.txt", "-m", "x"],
                       capture_output=True, text=True)
print(ended.stderr, end="")
print("exit", ended.returncode)
# Kilobytes: the most that a child had. Sanitizers take more.
print("little memory:", resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss < 1_000_000)
PY
