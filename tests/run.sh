#!/usr/bin/env bash
# Builds a preset (release unless named) and runs every test; the last line is "N passed, N failed".
set -uo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
jobs=$(nproc 2>/dev/null || echo 2)

if ! { cmake --preset "$preset" && cmake --build --preset "$preset"; }; then
  echo "the build failed" >&2
  echo "0 passed, 1 failed"
  exit 1
fi
report=$PWD/build/$preset/tests.xml
rm -f "$report"
ctest --preset "$preset" --parallel "$jobs" --output-junit "$report"
exec python3 -B tests/summary.py "$report"
