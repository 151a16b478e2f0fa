#!/usr/bin/env bash
# Runs a study of 2,000 simulations through resources/cluster/study.slurm on a Slurm of this machine
# alone: munge, slurmctld and slurmd from Debian's packages, on the loopback, in a folder that is
# removed. One of eight tasks is killed in the middle and requeued; the merged table has to be that of
# a single run, byte for byte. However it ends, but for a kill -9, nothing of it stays.
# usage: check_cluster.sh PROGRAM
set -euo pipefail

program=$(readlink -f -- "$1")
root=$(readlink -f -- "${BASH_SOURCE[0]}")
root=${root%/tests/dev/*}
scratch=$(mktemp -d /tmp/asperity_cluster.XXXXXX)
pids=()  # of the three daemons
job=

say() { printf 'cluster: %s\n' "$*" >&2; }
die() { say "$*"; tail -n 15 "$scratch"/*.log >&2 2>/dev/null || true; exit 1; }

# wait_until SECONDS COMMAND...: whether it succeeds in time.
wait_until() {
  local latest=$((SECONDS + $1))
  until "${@:2}"; do
    ((SECONDS < latest)) || return 1
    sleep 0.1
  done
}

# Processes that were given our configuration: those of the tasks, which Slurm lets go from here.
processes() {
  env -u SLURM_CONF grep -lsz "^SLURM_CONF=$scratch/" /proc/[0-9]*/environ 2>/dev/null |
    sed 's|[^0-9]||g' || true
}
are_gone() { [[ -z $(processes) ]]; }
no_jobs() { [[ -z $(timeout 5 squeue -h 2>/dev/null) ]]; }
daemons_are_gone() { ! kill -0 "${pids[@]}" 2>/dev/null; }

# Ends what was started here, and nothing else.
clean_up() {
  trap '' INT TERM HUP
  local pid
  if [[ -n $job ]]; then
    timeout 10 scancel --full --quiet "$job" 2>/dev/null || true
    wait_until 10 no_jobs || true
  fi
  if ((${#pids[@]} > 0)); then
    kill "${pids[@]}" 2>/dev/null || true
    wait_until 5 daemons_are_gone || kill -9 "${pids[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
  fi
  wait_until 3 are_gone || for pid in $(processes); do kill -9 "$pid" 2>/dev/null || true; done
  rm -rf "$scratch"
}
trap clean_up EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# Runs a command that takes long, so that a signal ends it at once.
patiently() {
  "$@" &
  local child=$! status=0
  wait "$child" || status=$?
  return "$status"
}

[[ $(id -u) == 0 ]] || die "needs root: slurmd starts jobs as their users"
chmod 755 "$scratch"
# The name by which the tasks' processes are found.
ln -s "$program" "$scratch/asperity"
program=$scratch/asperity

# ---- munge, with a key and a socket of its own
user=$(id -un munge 2>/dev/null) || die "munge is not installed"
mkdir -m 755 "$scratch/munge"
dd if=/dev/urandom of="$scratch/munge/key" bs=1024 count=1 status=none
chmod 600 "$scratch/munge/key"
chown -R "$user" "$scratch/munge"
setpriv --reuid="$user" --regid="$(id -gn "$user")" --clear-groups munged --foreground \
  --key-file="$scratch/munge/key" --socket="$scratch/munge/socket" --pid-file="$scratch/munge/pid" \
  --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" >"$scratch/munged.log" 2>&1 &
pids+=($!)
wait_until 10 test -S "$scratch/munge/socket" || die "munged does not start"

# ---- Slurm, on two ports that nobody uses
is_free() { ! (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }
port=26817
until is_free "$port" && is_free $((port + 1)); do ((port += 2)); done
mkdir -p "$scratch/state" "$scratch/spool"
host=$(hostname -s)
cat >"$scratch/slurm.conf" <<END
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket,cred_expire=5
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
KillWait=2
MinJobAge=300
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
# Nothing here uses control groups, which a container may not let us change; slurmd wants a plugin.
printf 'CgroupPlugin=cgroup/v1\nCgroupMountpoint=%s/cgroup\n' "$scratch" >"$scratch/cgroup.conf"
mkdir "$scratch/cgroup"
export SLURM_CONF=$scratch/slurm.conf
slurmctld -D -c >"$scratch/slurmctld.log" 2>&1 &
pids+=($!)
slurmd -D >"$scratch/slurmd.log" 2>&1 &
pids+=($!)
is_idle() { [[ $(sinfo -h -o %T 2>/dev/null) == idle* ]]; }
wait_until 60 is_idle || die "the node does not become idle"
say "munge, slurmctld and slurmd run after $SECONDS s"

# ---- The study
cat >"$scratch/study.json" <<'END'
{"schema": "asperity-study/1", "chunk": 5,
 "set": {"surface.elements": 2000, "ensemble.realizations": 40},
 "space": {"load.normal_force": {"from": 1e-3, "to": 1, "points": 50},
           "surface.hurst": {"from": 0.3, "to": 0.9, "points": 40}},
 "outputs": ["mu", "contact_fraction"]}
END
cd "$scratch"
export ASPERITY=$program
# More tasks than most machines have processors, so that some wait.
job=$(sbatch --parsable --array=1-8 "$root/resources/cluster/study.slurm" study.json shards)
say "job $job: 8 tasks"
task=  # the process of task 1
begins() {
  for task in $(processes); do
    if grep -qsxzF -- "1/8" "/proc/$task/cmdline"; then return 0; fi
  done
  return 1
}
is_ended() { ! grep -qsz . "/proc/$task/cmdline"; }  # that of a zombie is empty
# The log of the store's transactions grows with each chunk of five simulations.
log_size() { stat -c %s shards/shard_1.study-wal 2>/dev/null || printf 0; }
wait_until 120 begins || die "task 1 does not begin"
growths=0 size=0
while ((growths < 6)); do
  if is_ended; then die "task 1 ended before it could be killed"; fi
  now=$(log_size)
  if ((now > size)); then ((growths += 1)); size=$now; fi
  sleep 0.02
done
scontrol requeue "${job}_1"
wait_until 30 is_ended || die "task 1 does not end"
before=$("$program" study show shards/shard_1.study --json --quiet |
  sed -n 's/^  "done": \([0-9]*\),$/\1/p')
[[ $before -gt 0 && $before -lt 250 ]] ||
  die "task 1 had done ${before:-nothing} of 250 when it was killed"
say "task 1 was killed with $before of 250 simulations done, and requeued"

jobs_left() { squeue -h -r -j "$job" -t pending,running,completing -o %i 2>/dev/null; }
are_done() { [[ -z $(jobs_left) ]]; }
wait_until 900 are_done || die "the job does not end: $(jobs_left)"
[[ $(scontrol show job "${job}_1") == *Restarts=1* ]] || die "task 1 was not requeued"
say "all tasks have ended after $SECONDS s"
patiently "$program" study merge shards/shard_*.study -o whole.study --quiet ||
  die "the shards do not make a whole"
patiently "$program" study table whole.study -o merged.csv --quiet
patiently "$program" study run study.json -o single.study --quiet
patiently "$program" study table single.study -o single.csv --quiet
cmp merged.csv single.csv || die "the tables differ"
[[ $(grep -c '^[0-9]' merged.csv) == 2000 ]] || die "the table has not 2,000 rows"
say "2,000 simulations in 8 tasks, one of them killed: the table is that of a single run, byte for byte ($SECONDS s)"
