#!/usr/bin/env bash
# Whether clang-format 14 would leave every source as it is. `format.sh --fix` rewrites them instead.
set -euo pipefail
cd "$(dirname "$0")/../.."

formatter=
for name in clang-format-14 clang-format; do
  if "$name" --version 2>/dev/null | grep -q 'version 14\.'; then
    formatter=$name
    break
  fi
done
if [ -z "$formatter" ]; then
  echo "skipped: no clang-format 14 here; other versions lay code out differently" >&2
  exit 77
fi

sources() {
  find include lib tools tests bench examples fuzz \( -name '*.h' -o -name '*.cpp' \) -print0 \
    2>/dev/null || true # a folder may not exist
}

if [ "${1-}" = --fix ]; then
  sources | xargs -0 "$formatter" --style=file -i
elif ! wrong=$(sources | xargs -0 "$formatter" --style=file --dry-run -Werror 2>&1); then
  sed -n 's/^\([^ :]*\):.*error:.*/\1: not as clang-format 14 lays it out; run: make format/p' \
    <<<"$wrong" | sort -u
  exit 1
fi
