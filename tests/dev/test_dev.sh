#!/usr/bin/env bash
# Tests ./dev without network, compiler or packages: in a folder of its own, with a PATH that holds
# a few real tools and stand-ins for dpkg, apt, CMake, Ninja and CTest. Each stand-in notes its call
# in $calls and behaves as the files in $state tell it.
# shellcheck disable=SC2016 # the stand-ins expand what is quoted here
set -euo pipefail

here=$(readlink -f -- "${BASH_SOURCE[0]}")
repository=${here%/tests/dev/*}
scratch=$(readlink -f -- "$(mktemp -d)")
trap 'rm -rf "$scratch"' EXIT
export state=$scratch/state calls=$scratch/calls
tools=$scratch/tools
project="$scratch/a project" # the space is on purpose
failures=0

# ---- The stand-ins --------------------------------------------------------------------------

# Makes the stand-in named $1 of the script on stdin.
stand_in() {
  {
    printf '#!%s\nprintf "%%s\\n" "%s $*" >>"$calls"\n' "$(command -v bash)" "$1"
    cat
  } >"$tools/$1"
  chmod +x "$tools/$1"
}

# Makes PATH's only folder.
make_tools() {
  local tool
  mkdir -p "$tools"
  for tool in bash cat cp env flock grep mkdir readlink rm tail tee; do
    ln -s "$(command -v "$tool")" "$tools/$tool"
  done
  stand_in sleep <<<''
  stand_in id <<<'cat "$state/user"'
  stand_in dpkg-query <<'END'
for name in "$@"; do
  [[ $name == -* ]] || grep -qx "$name" "$state/missing" || printf 'installed %s\n' "$name"
done
END
  stand_in apt-get <<'END'
if [[ -s $state/locked && " $* " == *" install "* ]]; then
  rm "$state/locked"
  printf 'E: Could not get lock\n'
  exit 100
fi
if [[ " $* " == *" install "* ]]; then : >"$state/missing"; fi
END
  stand_in cmake <<'END'
[[ ! -e $state/broken_configuration ]] || { printf 'CMake Error\n' >&2; exit 1; }
mkdir -p ".build/$2"
: >".build/$2/build.ninja"
printf '%s\n' "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "CMAKE_CXX_COMPILER:STRING=/usr/bin/clang++-19" \
  "ASPERITY_TESTS:BOOL=${*##*TESTS=}" \
  >".build/$2/CMakeCache.txt"
END
  stand_in ninja <<'END'
if [[ $1 == -C ]]; then
  if [[ -e $2/fresh ]]; then printf 'ninja: no work to do.\n'; else printf '[0%%] Building\n'; fi
  exit 0
fi
[[ ! -e $state/broken_source ]] || { printf 'FAILED: main.o\nerror: expected\n'; exit 1; }
printf '[ 50%%] Building\n[100%%] Linking\n'
mkdir -p app
cp "$state/program" app/asperity
: >fresh
END
  stand_in ctest <<'END'
cat "$state/summary"
exit "$(cat "$state/ctest_status")"
END
}

# Makes the project and the state anew: root on a machine that has everything, nothing built.
start_anew() {
  rm -rf "$project" "$state" "$calls"
  mkdir -p "$project" "$state"
  cp "$repository/dev" "$project/dev"
  printf '{}\n' >"$project/CMakePresets.json"
  : >"$state/missing"
  : >"$calls"
  printf '0\n' >"$state/user"
  cat >"$state/program" <<'END'
#!/usr/bin/env bash
printf '%s\n' "$PWD" >"$state/folder"
printf '%s\n' "$PPID" >"$state/parent"
printf '<%s>\n' "$@"
exit "$(cat "$state/status" 2>/dev/null || printf 0)"
END
  chmod +x "$state/program"
}

# Calls dev (or the path in $dev) and keeps what it says in $out and $err, and its $status.
call() {
  status=0
  : >"$calls"
  PATH=$tools DISPLAY=${display-:1} WAYLAND_DISPLAY='' "${dev:-$project/dev}" "$@" \
    >"$scratch/out" 2>"$scratch/err" </dev/null || status=$?
  out=$(<"$scratch/out")
  err=$(<"$scratch/err")
}

# ---- Judging --------------------------------------------------------------------------------

# Compares text; $1 says what it is.
same() {
  [[ $2 == "$3" ]] && return
  failures=$((failures + 1))
  printf '%s: %s\n  is:     %q\n  should: %q\n' "$current" "$1" "$2" "$3"
}

# Looks for a pattern of the shell in a text.
like() {
  # shellcheck disable=SC2053 # a pattern is wanted
  [[ $2 == $3 ]] && return
  failures=$((failures + 1))
  printf '%s: %s\n  is:          %q\n  should match: %s\n' "$current" "$1" "$2" "$3"
}

# ---- The tests ------------------------------------------------------------------------------

test_help_lists_the_commands() {
  local command
  call help
  same status "$status" 0
  same stderr "$err" ''
  for command in run test check bench fuzz package help; do
    like 'the list' "$out" "*  $command *"
  done
  local help=$out
  call
  same 'bare dev' "$out" "$help"
  same 'status of bare dev' "$status" 0
}

test_bad_usage_is_one_line_and_status_2() {
  local command
  for command in nonsense 'check --nonsense' 'fuzz nonsense' 'package nonsense'; do
    # shellcheck disable=SC2086 # two words are two arguments
    call $command
    same "status of $command" "$status" 2
    same "stdout of $command" "$out" ''
    like "stderr of $command" "$err" 'dev: ?*'
    same "lines of $command" "${err//[^$'\n']/}" ''
  done
}

test_missing_packages_without_sudo() {
  printf '1000\n' >"$state/user"
  printf 'cmake\nlibfmt-dev\n' >"$state/missing"
  call run check
  same status "$status" 1
  same stdout "$out" ''
  same stderr "$err" \
    'dev: packages are missing and there is no sudo to install them: cmake libfmt-dev'

  stand_in sudo <<<'exit 1'
  call run check
  same 'status where sudo refuses' "$status" 1
  same 'lines where sudo refuses' "${err//[^$'\n']/}" ''
  rm "$tools/sudo"
}

test_missing_packages_are_installed() {
  printf 'cmake\nlibfmt-dev\n' >"$state/missing"
  printf 'once\n' >"$state/locked"
  call run check
  same status "$status" 0
  like 'calls' "$(<"$calls")" '*apt-get *update*apt-get *install cmake libfmt-dev*cmake *'
  like 'calls' "$(<"$calls")" '*--no-install-recommends*'

  printf 'cmake\n' >"$state/missing"
  printf '1000\n' >"$state/user"
  stand_in sudo <<<'[[ $1 == -n ]] || exec "$@"'
  call run check
  same 'status with sudo' "$status" 0
  like 'calls with sudo' "$(<"$calls")" '*sudo env *apt-get *install cmake'*
  rm "$tools/sudo"
}

test_first_run_builds_and_second_does_not() {
  call run check
  same 'first status' "$status" 0
  same 'stdout is the program'"'"'s' "$out" '<check>'
  like 'first stderr' "$err" 'dev: configuring*dev: building*'
  like 'first calls' "$(<"$calls")" '*cmake --preset release*-DASPERITY_TESTS=OFF*ninja asperity*'

  call run check
  same 'second stderr' "$err" ''
  same 'second stdout' "$out" '<check>'
  same 'parent, dev having become the program' "$(<"$state/parent")" "$$"
  [[ $(<"$calls") != *cmake' '--* ]] || same 'second calls' "$(<"$calls")" 'no cmake'
  [[ $(<"$calls") != *'ninja asperity'* ]] || same 'second calls' "$(<"$calls")" 'no build'
}

test_arguments_status_and_folder_pass_through() {
  printf '7\n' >"$state/status"
  call run check
  (cd "$scratch" && call run check 'a b' '' '*' '--set=x y' $'two\nlines' "it's" "\\" -- &&
    same status "$status" 7 && same folder "$(<"$state/folder")" "$scratch" &&
    same arguments "$out" \
      $'<check>\n<a b>\n<>\n<*>\n<--set=x y>\n<two\nlines>\n<it'"'"$'s>\n<\\>\n<-->' &&
    same stderr "$err" '' && exit "$failures") || failures=$?

  ln -s "$project/dev" "$scratch/link"
  dev=$scratch/link call run check
  same 'status through a link' "$status" 7
  same 'stderr through a link' "$err" ''
  rm "$scratch/link"
}

test_without_display_renders() {
  call run check
  display='' call run
  same arguments "$out" \
    $'<render>\n<'"$project"$'/resources/scenes/figure_1.json>\n<--frames>\n<1>\n<-o>\n<out/>'
  like stderr "$err" 'dev: no display*'
  same 'lines' "${err//[^$'\n']/}" ''
  display='' call run check
  same 'stderr with arguments' "$err" ''
  call run
  same 'stdout with a display' "$out" '<>'
}

test_failures_do_not_start_the_program() {
  : >"$state/broken_configuration"
  call run check
  same 'status of a broken configuration' "$status" 1
  like 'stderr of a broken configuration' "$err" '*CMake Error*dev: configuring failed'
  rm "$state/broken_configuration"
  : >"$state/broken_source"
  call run check
  same 'status of a broken source' "$status" 1
  same 'stdout of a broken source' "$out" ''
  like 'stderr of a broken source' "$err" '*error: expected*dev: the build failed'
  rm "$state/broken_source"
  call run check
  same 'status of a mended source' "$status" 0
}

test_configures_anew_when_it_must() {
  call run check
  touch -d '1 minute' "$project/CMakePresets.json"
  call run check
  like 'calls after a change of presets' "$(<"$calls")" '*cmake --preset*'
  same 'its folder made anew' "$(grep -e --fresh "$calls" || true)" ''
  sed -i 's/clang.*/g++/' "$project/.build/release/CMakeCache.txt"
  touch -d '2 minutes' "$project/CMakePresets.json"
  call run check
  like 'calls for a folder of another compiler' "$(<"$calls")" '*cmake --preset*--fresh*'
  touch -d '1 minute ago' "$project/CMakePresets.json"
  call run check
  same 'stderr after that' "$err" ''
  mv "$project" "$scratch/moved"
  dev=$scratch/moved/dev call run check
  like 'calls after a move' "$(<"$calls")" '*cmake --preset*--fresh*'
  rm -rf "$scratch/moved"
}

test_tests_end_with_their_count() {
  printf '0\n' >"$state/ctest_status"
  printf '100%% tests passed, 0 tests failed out of 12\n' >"$state/summary"
  call test
  same status "$status" 0
  same 'last line' "${out##*$'\n'}" '12 passed, 0 failed'
  like calls "$(<"$calls")" '*cmake --preset release*-DASPERITY_TESTS=ON*ninja all*ctest *'

  printf '8\n' >"$state/ctest_status"
  printf '%s\n' '75% tests passed, 1 tests failed out of 4' '' \
    'The following tests did not run:' $'\t  3 - window (Skipped)' '' \
    'The following tests FAILED:' $'\t  2 - missing (Not Run)' 'Errors while running CTest' \
    >"$state/summary"
  call test
  same 'status with failures' "$status" 8
  same 'last line with failures' "${out##*$'\n'}" '2 passed, 1 failed'

  : >"$state/summary"
  call test
  [[ $status != 0 ]] || same 'status without tests' "$status" 'not 0'

  call run check
  same 'stderr of run after test' "$err" ''
}

test_fuzz_feeds_every_reader() {
  mkdir -p "$project/tests/fuzz/corpus/"{scene,x3p_xml,lesson}
  cat >"$project/tests/fuzz/run_fuzz" <<'END'
#!/usr/bin/env bash
printf '%s\n' "$*"
[[ ! -e $state/found ]]
END
  chmod +x "$project/tests/fuzz/run_fuzz"
  call fuzz 30
  same status "$status" 0
  same runs "$out" $'lesson -max_total_time=30\nscene -max_total_time=30\nx3p_xml -max_total_time=30'
  like calls "$(<"$calls")" '*cmake --preset fuzz*ninja all*'
  : >"$state/found"
  call fuzz 30
  same 'status where something is found' "$status" 1
  like 'stderr where something is found' "$err" '*dev: an input that breaks lesson*'
}

test_a_man_page_is_whole_or_not_there() {
  local make=$repository/resources/linux/make_man_page page=$scratch/asperity.1.gz tool
  for tool in sh dirname gzip mv; do ln -sf "$(command -v "$tool")" "$tools/$tool"; done
  make_page() {
    status=0
    PATH=$tools "$tools/sh" "$make" program "$page" 2>/dev/null || status=$?
  }
  : >"$page" # what an earlier build left
  make_page
  [[ $status != 0 && ! -e $page ]] || same 'without help2man' "$status $(ls "$page")" 'no page'
  stand_in help2man <<<'printf "a half"; exit 1'
  make_page
  [[ $status != 0 && ! -e $page ]] || same 'where help2man fails' "$status $(ls "$page")" 'no page'
  stand_in help2man <<<''
  make_page
  [[ $status != 0 && ! -e $page ]] || same 'an empty page' "$status $(ls "$page")" 'no page'
  stand_in help2man <<<'printf "%s\n" "${@: -1}"'
  make_page
  same 'status with help2man' "$status" 0
  same 'the page' "$(gzip -dc "$page")" program
  same 'other files' "$(echo "$page"*)" "$page"
  rm "$tools/help2man" "$tools/dirname" "$tools/gzip" "$tools/mv" "$tools/sh"
}

test_display_for_tests() {
  local with_display=$repository/tests/dev/with_display
  if ! command -v Xvfb matchbox-window-manager xdotool >/dev/null; then
    printf 'no Xvfb here: with_display is not tested\n'
    return
  fi
  local status=0 geometry
  geometry=$("$with_display" xdotool getdisplaygeometry)
  same 'size of the display' "$geometry" '1600 1000'
  # shellcheck disable=SC2016 # for the inner shell
  "$with_display" bash -c '[[ $1 == "a b" && $(cat) == in ]] && exit 7' - 'a b' <<<in || status=$?
  same 'status, arguments and stdin' "$status" 7
}

# ---- All of them ----------------------------------------------------------------------------

make_tools
count=0
for current in $(compgen -A function test_); do
  before=$failures
  start_anew
  "$current"
  count=$((count + 1))
  verdict=ok
  if ((failures > before)); then verdict=FAILED; fi
  printf '%-7s %s\n' "$verdict" "$current"
done
printf '%d tests, %d failures\n' "$count" "$failures"
((failures == 0))
