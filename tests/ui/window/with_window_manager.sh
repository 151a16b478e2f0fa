#!/bin/sh
# with_window_manager.sh MANAGER PROGRAM ARGS...: runs the program while the manager manages.
manager=$1
shift
"$manager" -use_titlebar no &
pid=$!
"$@"
result=$?
kill "$pid"
exit "$result"
