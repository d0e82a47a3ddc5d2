//! `cargo xtask cluster`: studies on a real Slurm and under GNU parallel, with daemons that are killed, compared byte by byte.
//!
//! Wants Debian's `slurmctld slurmd slurm-client munge parallel` and root; the whole cluster lives in one folder of the
//! target directory.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context as _, Result, bail, ensure};

use crate::cargo::{cargo, run as run_command, target};

const PACKAGES: &str = "slurmctld slurmd slurm-client munge parallel";
const SHARDS: usize = 16;
/// Longest time that anything may take.
const PATIENCE: Duration = Duration::from_mins(30);

/// A study of so many points on one machine, killed and resumed, in shards, and on the cluster.
pub fn run(root: &Path, points: u64) -> Result<()> {
    for program in ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "parallel"] {
        let found = Command::new("sh")
            .args(["-c", &format!("command -v {program}")])
            .stdout(Stdio::null())
            .status()?;
        ensure!(
            found.success(),
            "`{program}` is missing: apt-get install --no-install-recommends {PACKAGES}"
        );
    }
    run_command(cargo(root).args(["build", "--release", "--package", "dalembert"]))?;
    let program = target(root).join("release/dalembert");
    let folder = target(root).join("cluster");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder)?;
    for name in ["fan.toml", "fan_study.toml"] {
        fs::copy(root.join("examples").join(name), folder.join(name))?;
    }
    // The example has five points of its grid.
    let samples = points.div_ceil(5).to_string();
    let study = Study { program, folder: folder.clone(), samples };

    let begun = Instant::now();
    study.ok("whole.csv", &[])?;
    println!("{} points on this machine: {:.1} s", 5 * points.div_ceil(5), begun.elapsed().as_secs_f64());

    let length = fs::metadata(folder.join("whole.csv"))?.len();
    let mut kills = 0;
    for part in 1..=5 {
        let mut child = study.spawn("killed.csv", &[])?;
        wait(|| Ok(study.length("killed.csv.part") > length * part / 6), &mut child)?;
        if child.try_wait()?.is_none() {
            child.kill()?;
            kills += 1;
        }
        child.wait()?;
    }
    study.ok("killed.csv", &["--force"])?;
    study.same("killed.csv")?;
    println!("killed {kills} times and resumed: the same bytes");
    ensure!(kills == 5, "the study ended before it was killed five times: ask for more points");

    let shards = format!(
        "parallel --jobs 2 {} study fan_study.toml --samples {} -o parallel.csv --threads 1 --shard {{}}/{SHARDS} ::: $(seq {SHARDS})",
        study.program.display(),
        study.samples
    );
    quiet(Command::new("sh").args(["-c", &shards]).current_dir(&folder))?;
    study.ok("parallel.csv", &["--merge"])?;
    study.same("parallel.csv")?;
    println!("{SHARDS} shards by GNU parallel: the same bytes");

    let mut slurm = Slurm::start(&folder.join("slurm"))?;
    let done = study.on_slurm(&mut slurm);
    slurm.stop();
    done
}

/// The study that is carried out again and again.
struct Study {
    program: PathBuf,
    folder: PathBuf,
    samples: String,
}

impl Study {
    fn command(&self, table: &str, more: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command
            .current_dir(&self.folder)
            .args(["study", "fan_study.toml", "--samples", &self.samples, "-o", table])
            .args(more)
            .stdout(Stdio::null());
        command
    }

    fn ok(&self, table: &str, more: &[&str]) -> Result<()> {
        quiet(&mut self.command(table, more))
    }

    fn spawn(&self, table: &str, more: &[&str]) -> Result<Child> {
        Ok(self.command(table, more).spawn()?)
    }

    fn length(&self, name: &str) -> u64 {
        fs::metadata(self.folder.join(name)).map_or(0, |file| file.len())
    }

    /// Compares a table with that of the undisturbed run.
    fn same(&self, table: &str) -> Result<()> {
        let compared = Command::new("cmp").args(["whole.csv", table]).current_dir(&self.folder).status()?;
        ensure!(compared.success(), "{table} differs from whole.csv in {}", self.folder.display());
        Ok(())
    }

    fn shards_of(&self, table: &str) -> usize {
        let of = format!("-of-{SHARDS}.csv");
        let stem = format!("{}.shard-", table.trim_end_matches(".csv"));
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        names.filter(|name| name.starts_with(&stem) && name.ends_with(&of)).count()
    }

    fn on_slurm(&self, slurm: &mut Slurm) -> Result<()> {
        let shards = SHARDS.to_string();
        // The node dies while shards are being solved, and comes back.
        let mut child = self.command("slurm.csv", &["--slurm", &shards]).envs(slurm.environment()).spawn()?;
        wait(|| Ok(self.shards_of("slurm.csv") >= 3), &mut child)?;
        slurm.kill_node()?;
        thread::sleep(Duration::from_secs(2));
        slurm.start_node()?;
        let status = child.wait()?;
        ensure!(status.success(), "the study on Slurm failed after its node was killed");
        self.same("slurm.csv")?;
        println!("{SHARDS} shards by Slurm, slurmd killed in between: the same bytes");

        // Lost shards alone are sent again.
        fs::remove_file(self.folder.join("slurm.csv"))?;
        for lost in [2, 7, 16] {
            fs::remove_file(self.folder.join(format!("slurm.shard-{lost}-of-{SHARDS}.csv")))?;
        }
        quiet(self.command("slurm.csv", &["--slurm", &shards]).envs(slurm.environment()))?;
        self.same("slurm.csv")?;
        println!("three lost shards sent again: the same bytes");

        // Another number of shards beside the old ones is refused by name, and serves once these are gone.
        fs::remove_file(self.folder.join("slurm.csv"))?;
        let mut other = self.command("slurm.csv", &["--slurm", "5"]);
        let refused = other.envs(slurm.environment()).stderr(Stdio::piped()).output()?;
        let why = String::from_utf8_lossy(&refused.stderr).into_owned();
        ensure!(!refused.status.success() && why.contains("shards of 5, 16"), "shards of two numbers: {why}");
        for number in 1..=SHARDS {
            fs::remove_file(self.folder.join(format!("slurm.shard-{number}-of-{SHARDS}.csv")))?;
        }
        self.ok("slurm.csv", &["--merge"])?;
        self.same("slurm.csv")?;
        println!("5 shards in place of {SHARDS}: the same bytes");
        Ok(())
    }
}

/// A cluster of one node: munged, slurmctld and slurmd.
struct Slurm {
    folder: PathBuf,
}

impl Slurm {
    fn start(folder: &Path) -> Result<Self> {
        for part in ["state", "spool", "log"] {
            fs::create_dir_all(folder.join(part))?;
        }
        let host = Command::new("hostname").arg("-s").output()?;
        let host = String::from_utf8_lossy(&host.stdout).trim().to_owned();
        let here = folder.display();
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let configuration = format!(
            "ClusterName=one\nSlurmctldHost={host}(127.0.0.1)\nSlurmctldPort=26817\nSlurmdPort=26818\nSlurmUser=root\n\
             SlurmdUser=root\nAuthType=auth/munge\nAuthInfo=socket={here}/munge.socket\nCredType=cred/munge\n\
             StateSaveLocation={here}/state\nSlurmdSpoolDir={here}/spool\nSlurmctldPidFile={here}/slurmctld.pid\n\
             SlurmdPidFile={here}/slurmd.pid\nSlurmctldLogFile={here}/log/slurmctld.log\n\
             SlurmdLogFile={here}/log/slurmd.log\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n\
             SwitchType=switch/none\nMpiDefault=none\nJobAcctGatherType=jobacct_gather/none\n\
             AccountingStorageType=accounting_storage/none\nSelectType=select/cons_tres\n\
             SelectTypeParameters=CR_Core\nSchedulerParameters=sched_interval=1,batch_sched_delay=0\n\
             ReturnToService=2\nSlurmdTimeout=10\nSlurmdParameters=config_overrides\nMaxArraySize=10001\n\
             NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN\n\
             PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP\n"
        );
        fs::write(folder.join("slurm.conf"), configuration)?;
        fs::write(folder.join("cgroup.conf"), "CgroupAutomount=no\n")?;
        let key = folder.join("munge.key");
        quiet(
            Command::new("sh")
                .args(["-c", "head -c 1024 /dev/urandom > \"$0\" && chmod 600 \"$0\""])
                .arg(&key),
        )?;
        let at = |name: &str| folder.join(name).display().to_string();
        quiet(Command::new("munged").args([
            "--force".to_owned(),
            format!("--key-file={}", at("munge.key")),
            format!("--socket={}", at("munge.socket")),
            format!("--pid-file={}", at("munged.pid")),
            format!("--log-file={}", at("log/munged.log")),
            format!("--seed-file={}", at("munge.seed")),
        ]))?;
        let slurm = Self { folder: folder.to_owned() };
        quiet(Command::new("slurmctld").arg("-c").envs(slurm.environment()))?;
        slurm.start_node()?;
        Ok(slurm)
    }

    fn environment(&self) -> [(&'static str, PathBuf); 1] {
        [("SLURM_CONF", self.folder.join("slurm.conf"))]
    }

    fn start_node(&self) -> Result<()> {
        quiet(Command::new("slurmd").arg("-c").envs(self.environment()))
    }

    /// Kills the daemon of the node and the tasks that it runs.
    fn kill_node(&self) -> Result<()> {
        for pattern in ["^slurmd", "study fan_study.toml .*--shard"] {
            let _ = Command::new("pkill").args(["-9", "-f", pattern]).status()?;
        }
        Ok(())
    }

    fn stop(&self) {
        for name in ["slurmd.pid", "slurmctld.pid", "munged.pid"] {
            if let Ok(number) = fs::read_to_string(self.folder.join(name)) {
                let _ = Command::new("kill").arg(number.trim()).status();
            }
        }
    }
}

/// Waits for a condition while a process runs.
fn wait(mut is_met: impl FnMut() -> Result<bool>, child: &mut Child) -> Result<()> {
    let begun = Instant::now();
    while !is_met()? && child.try_wait()?.is_none() {
        ensure!(begun.elapsed() < PATIENCE, "nothing happens any more");
        thread::sleep(Duration::from_millis(2));
    }
    Ok(())
}

/// Runs a command to its end; its own words stand in the error.
fn quiet(command: &mut Command) -> Result<()> {
    let output = command.stdin(Stdio::null()).stderr(Stdio::piped()).output();
    let output = output.with_context(|| format!("{command:?}"))?;
    if !output.status.success() {
        bail!("{command:?}: {}", String::from_utf8_lossy(&output.stderr).trim());
    }
    Ok(())
}
