#!/usr/bin/env bash
# take_over.sh BUILD LIBRARIES LAUNCHER COMPILER ARGUMENT...: compiles as asked, by LAUNCHER where that is not empty.  But
# an object of our LIBRARIES, a pattern, is taken from BUILD where that has compiled the same text by the same words,
# those of a build type (-O, -g, -DNDEBUG) apart.
set -euo pipefail
build=$1 libraries=$2 launcher=$3
shift 3

# Sets `words` to what counts of a command, and `source`, `object` and `depfile` to its files.
read_command() {
  words="" source="" object="" depfile=""
  while [ $# -gt 0 ]; do
    case $1 in
      -o) object=$2; shift ;;
      -c) source=$2; shift ;;
      -MF) depfile=$2; shift ;;
      -MT) shift ;;
      -MD | -O* | -g* | -DNDEBUG) ;;
      *) words+=" $1" ;;
    esac
    shift
  done
}

read_command "$@"
inner=CMakeFiles/${object#*CMakeFiles/}
if [[ $inner =~ ^CMakeFiles/plumb_($libraries)\.dir/ ]]; then
  asked=$words asked_source=$source asked_object=$object asked_depfile=$depfile
  command=$(grep -F -- " -o $inner " "$build/compile_commands.json") || command=""
  command=${command#*\"command\": \"}
  command=${command%\"*}
  command=${command//\\\"/\"}
  command=${command//\\\\/\\}
  eval "command=($1 ${command#*"$1 "})"
  read_command "${command[@]}"
  if [ "$words" = "$asked" ] && cmp -s "$source" "$asked_source" && [ "$build/$inner" -nt "$source" ]; then
    cp "$build/$inner" "$asked_object"
    [ -z "$asked_depfile" ] || echo "$asked_object:" >"$asked_depfile"
    exit
  fi
fi
exec ${launcher:+"$launcher"} "$@"
