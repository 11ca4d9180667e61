# Sourced by the scripts beside it, from the project's root.

say() { printf '== %s\n' "$*"; }

# shown LOG PATTERN: keeps what it reads in LOG; a terminal shows how far it is, by what matches.
shown() {
  local line
  while IFS= read -r line; do
    printf '%s\n' "$line"
    if [ -t 2 ] && [[ $line =~ $2 ]]; then printf '\r\033[K   %s' "${BASH_REMATCH[0]}" >&2; fi
  done >"$1"
  if [ -t 2 ]; then printf '\r\033[K' >&2; fi
}

# hurry PID: that process is waited for, so it and what it has started (each compiler in a process
# group of its own) no longer give way to other programs. Only root may; else nothing changes.
hurry() {
  local child
  renice -n "$(nice)" -p "$1" >/dev/null 2>&1 || true
  for child in $(cat "/proc/$1/task/"*/children 2>/dev/null); do hurry "$child"; done
}

# build_preset PRESET [TARGET...]: configures and builds, quietly unless it fails. With
# ROCINANTE_WERROR=1 in the environment, as CI and developers have it, a warning fails it. One at a
# time in each folder: a second one waits, and builds what the first has not. ROCINANTE_AHEAD is the
# process of a build of low priority, which is hurried when a second one waits for it.
build_preset() {
  local preset=$1
  shift
  local started=$SECONDS log=build/$preset.log
  mkdir -p build
  say "build: $preset"
  local targets=()
  [ $# -gt 0 ] && targets=(--target "$@")
  local options=()
  [ "${ROCINANTE_WERROR:-0}" = 0 ] || options=(-DROCINANTE_WERROR=ON)
  local lock ahead
  exec {lock}>>"build/$preset.lock"
  if ! flock -n "$lock"; then
    ahead=$(cat "build/$preset.lock")
    [ -z "$ahead" ] || hurry "$ahead"
    flock "$lock"
  fi
  printf '%s' "${ROCINANTE_AHEAD:-}" >"build/$preset.lock"
  if ! { cmake --preset "$preset" "${options[@]}" && cmake --build --preset "$preset" "${targets[@]}"; } 2>&1 |
    shown "$log" '^\[[0-9]+/[0-9]+\]'; then
    grep -E -A 12 'error|FAILED' "$log" | head -n 60 >&2 || true
    echo "build: $preset failed; all that it said is in $log" >&2
    exec {lock}>&-
    return 2
  fi
  exec {lock}>&-
  # Not what was switched off.
  sed -n 's/^-- rocinante: \(.*: built without \)/   \1/p' "$log"
  say "build: $preset in $((SECONDS - started)) s"
}

# Failures whole, a mark for each hundred tests that went well: a log that can be read.
show_test_progress() {
  awk '/Test +#[0-9]+:/ && / Passed / { n++; if (n % 100 == 0) { printf "   %d passed\n", n; fflush() } next }
       /^ *Start +[0-9]+:/ { next }
       { print; fflush() }'
}

# count_results JUNIT_XML: prints PASSED FAILED SKIPPED.
count_results() {
  python3 - "$1" <<'PY'
import sys, xml.etree.ElementTree as tree
try:
    suite = tree.parse(sys.argv[1]).getroot()
except (OSError, tree.ParseError):
    print("0 1 0")
    sys.exit()
passed = failed = skipped = 0
for case in suite.iter("testcase"):
    status = case.get("status")
    if status == "fail":
        failed += 1
    elif case.find("skipped") is not None or status in ("notrun", "disabled"):
        skipped += 1
    else:
        passed += 1
print(passed, failed, skipped)
PY
}

# list_skipped PRESET...: one line a skipped test, with its reason.
list_skipped() {
  for preset in "$@"; do
    python3 - "build/$preset/results.xml" "$preset" <<'PY'
import re, sys, xml.etree.ElementTree as tree
try:
    suite = tree.parse(sys.argv[1]).getroot()
except (OSError, tree.ParseError):
    sys.exit()
for case in suite.iter("testcase"):
    if case.find("skipped") is None:
        continue
    said = case.findtext("system-out") or ""
    reason = re.search(r"(skipped: .*|.*Skipped\n.*|no real data here.*)", said)
    print(f"   skipped ({sys.argv[2]}): {case.get('name')}: "
          f"{reason.group(0).strip() if reason else 'no reason given'}")
PY
  done
}
