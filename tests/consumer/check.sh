#!/usr/bin/env bash
# Installs a build tree into a scratch directory, then builds and runs what uses it, both ways.
# check.sh CMAKE BUILD COMPILER [FLAGS]
set -euo pipefail
cmake=$1 build=$2 compiler=$3 flags=${4-}
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/log" || { cat "$scratch/log"; exit 1; }
mv "$scratch/first" "$scratch/prefix" # nothing installed may know where it was put
"$scratch/prefix/bin/tristim" --version

"$cmake" -S "$here" -B "$scratch/cmake" -D CMAKE_PREFIX_PATH="$scratch/prefix" \
  -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_CXX_FLAGS="$flags"
"$cmake" --build "$scratch/cmake"

mkdir "$scratch/make"
cp "$here"/*.cpp "$here/Makefile" "$scratch/make"
PKG_CONFIG_PATH=$(dirname "$(find "$scratch/prefix" -name tristim.pc)")
export PKG_CONFIG_PATH
env -u MAKEFLAGS CXX="$compiler" CXXFLAGS="$flags" make -C "$scratch/make"

for way in cmake make; do
  cd "$scratch/$way"
  ./matrix
  ./picture
done
