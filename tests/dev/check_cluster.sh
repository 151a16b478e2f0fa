#!/usr/bin/env bash
# Runs a study of 2,000 simulations through resources/cluster/study.slurm on a Slurm of this machine
# alone: munge, slurmctld and slurmd from Debian's packages, on the loopback, in a folder that is
# removed. One of eight tasks is killed in the middle and requeued; the merged table has to be that of
# a single run, byte for byte.
# usage: check_cluster.sh PROGRAM
set -euo pipefail

program=$(readlink -f -- "$1")
root=$(readlink -f -- "${BASH_SOURCE[0]}")
root=${root%/tests/dev/*}
scratch=$(mktemp -d /tmp/asperity_cluster.XXXXXX)
pids=()

say() { printf 'cluster: %s\n' "$*" >&2; }
die() { say "$*"; tail -n 15 "$scratch"/*.log >&2 2>/dev/null || true; exit 1; }

# Ends what was started here, and nothing else.
clean_up() {
  local pid
  if [[ -n ${SLURM_CONF:-} ]]; then
    scancel --full --quiet --user="$(id -un)" 2>/dev/null || true
    for _ in {1..100}; do  # until the steps of the jobs have ended
      [[ -n $(timeout 5 squeue -h 2>/dev/null) ]] || break
      sleep 0.1
    done
  fi
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  for _ in {1..50}; do
    kill -0 "${pids[@]}" 2>/dev/null || break
    sleep 0.1
  done
  for pid in "${pids[@]}"; do kill -9 "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$scratch"
}
trap clean_up EXIT

[[ $(id -u) == 0 ]] || die "needs root: slurmd starts jobs as their users"
chmod 755 "$scratch"

# ---- munge, with a key and a socket of its own
user=$(id -un munge 2>/dev/null) || die "munge is not installed"
mkdir -m 755 "$scratch/munge"
dd if=/dev/urandom of="$scratch/munge/key" bs=1024 count=1 status=none
chmod 600 "$scratch/munge/key"
chown -R "$user" "$scratch/munge"
runuser -u "$user" -- munged --foreground --key-file="$scratch/munge/key" \
  --socket="$scratch/munge/socket" --pid-file="$scratch/munge/pid" \
  --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" >"$scratch/munged.log" 2>&1 &
pids+=($!)
for _ in {1..50}; do [[ -S $scratch/munge/socket ]] && break; sleep 0.1; done
[[ -S $scratch/munge/socket ]] || die "munged does not start"

# ---- Slurm
mkdir -p "$scratch/state" "$scratch/spool"
host=$(hostname -s)
cat >"$scratch/slurm.conf" <<END
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
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
for _ in {1..100}; do
  [[ $(sinfo -h -o %T 2>/dev/null) == idle* ]] && break
  sleep 0.3
done
[[ $(sinfo -h -o %T 2>/dev/null) == idle* ]] || die "the node does not become idle"
say "munge, slurmctld and slurmd run"

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
# More tasks than processors, so that one is surely in the middle when it is killed.
job=$(sbatch --parsable --array=1-8 "$root/resources/cluster/study.slurm" study.json shards)
say "job $job"
state() { squeue -h -r -t all -j "${job}_$1" -o %T 2>/dev/null | head -n 1; }
done_of() {
  "$program" study show "shards/shard_$1.study" --json --quiet 2>/dev/null |
    sed -n 's/^  "done": \([0-9]*\),$/\1/p'
}
killed=
for _ in {1..600}; do
  pid=$(pgrep -f -- "shards/shard_1.study --shard 1/8" | head -n 1) || true
  if [[ -n $pid && -s shards/shard_1.study-wal ]]; then
    sleep 0.3
    scontrol requeue "${job}_1" && killed=yes
    break
  fi
  [[ $(state 1) != COMPLETED ]] || die "task 1 ended before it could be killed"
  sleep 0.05
done
[[ -n $killed ]] || die "task 1 did not begin"
sleep 3
before=$(done_of 1)
[[ $before -gt 0 && $before -lt 250 ]] || die "task 1 had done ${before:-nothing} of 250 when it was killed"
say "task 1 was killed with $before of 250 simulations done, and requeued"

for _ in {1..1200}; do
  [[ -n $(squeue -h -r -j "$job" -t pending,running,completing -o %T 2>/dev/null) ]] || break
  sleep 0.5
done
[[ -z $(squeue -h -r -j "$job" -t pending,running,completing -o %T 2>/dev/null) ]] || die "the job does not end"
[[ $(scontrol show job "${job}_1" | grep -c 'Restarts=1') -ge 1 ]] || die "task 1 was not requeued"
"$program" study merge shards/shard_*.study -o whole.study --quiet || die "the shards do not make a whole"
"$program" study table whole.study -o merged.csv --quiet
"$program" study run study.json -o single.study --quiet
"$program" study table single.study -o single.csv --quiet
cmp merged.csv single.csv || die "the tables differ"
say "2,000 simulations in 8 tasks, one of them killed: the table is that of a single run, byte for byte"
