#!/usr/bin/env bash
# tidy.sh [FILE...]: checks the format (.clang-format) of the C++ files named, or of all, and runs clang-tidy (.clang-tidy) over
# those that build/release compiles: the named ones each by itself, all of them as they are compiled together.
# A header is checked with the sources that include it. Changes nothing. Installs both tools where they are missing; needs the built
# preset release. Exit code: 0 nothing found, 1 something found, 2 could not check.
set -uo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root" || exit 2
oversketch_install clang-format clang-tidy || exit 2
[ -f build/release/compile_commands.json ] ||
  { echo "tidy.sh: no build/release/compile_commands.json; run cmake --preset release && cmake --build --preset release" >&2; exit 2; }
mkdir -p build/tidy
database=build/tidy/compile_commands.json
python3 - build/release/compile_commands.json "$database" $# <<'EXPAND' || exit 2
import json, re, sys
found = []
for entry in json.load(open(sys.argv[1])):
    files = re.findall('#include "(.+)"', open(entry["file"]).read()) if "/Unity/unity_" in entry["file"] else [entry["file"]]
    if sys.argv[3] == "0" and any("/build/release/" not in file for file in files):
        files = [entry["file"]]
    for file in files:
        command = re.sub(r" -Winvalid-pch -include \S+", "", entry["command"])  # a header that GCC has precompiled
        found.append({**entry, "file": file, "command": command.replace(entry["file"], file)})
json.dump(found, open(sys.argv[2], "w"), indent=0)
EXPAND

if [ $# -gt 0 ]; then
  files=("$@")
else
  mapfile -t files < <(git ls-files '*.h' '*.cxx')
fi
together=()
if [ $# -eq 0 ]; then
  mapfile -t together < <(grep -oP '"file": "\K.*/Unity/unity_[^"]*' "$database" | sort -u)
fi
compiled=()
for file in "${files[@]}"; do
  [ -f "$file" ] || { echo "tidy.sh: there is no file $file" >&2; exit 2; }
  grep -qF "\"file\": \"$(realpath "$file")\"" "$database" && compiled+=("$file")
done
compiled+=("${together[@]}")

# A source that is compiled together with others is included by what CMake has written.
included=(--checks=-bugprone-suspicious-include "--header-filter=^$PWD/(Kernels|Filters|Widgets|Applications|Testing)/.*\.(h|cxx)$")
[ ${#together[@]} -gt 0 ] || included=()

found=0
clang-format --dry-run -Werror "${files[@]}" || found=1
# clang-tidy counts the warnings that it hides in other people's headers; those lines are dropped.
[ ${#compiled[@]} -eq 0 ] || printf '%s\0' "${compiled[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option "${included[@]}" 2> >(grep -v ' warnings\? generated\.$' >&2) || found=1
[ "$found" -eq 0 ] && echo "Nothing found in ${#files[@]} files; clang-tidy ran ${#compiled[@]} times."
exit "$found"
