#!/usr/bin/env bash
# slurm_node.sh FOLDER COMMAND …: starts Slurm with one node and one controller on this machine, with all their files in FOLDER,
# runs the command, waits for all jobs, and stops Slurm. Exits with the command's code, or with 77 if Slurm cannot be started,
# which needs root and the packages slurm-wlm and munge.
set -u
folder=$(readlink -f "$1")
shift
[ "$(id -u)" -eq 0 ] || exit 77
for program in munged slurmctld slurmd sbatch squeue sinfo python3; do command -v "$program" >/dev/null || exit 77; done

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }
mkdir -p "$folder/state" "$folder/spool"
dd if=/dev/urandom of="$folder/munge.key" bs=128 count=1 status=none
chmod 700 "$folder"
chmod 600 "$folder/munge.key"
export SLURM_CONF=$folder/slurm.conf
host=$(hostname -s)
cat >"$SLURM_CONF" <<END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END

servers=()
end() {
    kill "${servers[@]}" 2>/dev/null
    wait "${servers[@]}" 2>/dev/null
}
trap end EXIT
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munge.pid" \
    --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" >"$folder/munged.out" 2>&1 &
servers+=($!)
for ((i = 0; i < 100; ++i)); do [ -S "$folder/munge.socket" ] && break; sleep 0.1; done
slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.out" 2>&1 &
servers+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >"$folder/slurmd.out" 2>&1 &
servers+=($!)
for ((i = 0; i < 300; ++i)); do
    [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break
    sleep 0.1
done
[ "$(sinfo -h -o %t 2>/dev/null)" = idle ] || exit 77

"$@"
code=$?
while [ -n "$(squeue -h 2>/dev/null)" ]; do sleep 0.2; done
exit "$code"
