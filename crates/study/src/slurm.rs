//! Shards of a study as a job array of Slurm: submitted, waited for, and sent again where they were lost.

use std::{
    ffi::{OsStr, OsString},
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    thread,
    time::Duration,
};

use dalembert_core::Text;

use crate::{StudyError, output::Shard};

/// Times that lost shards are sent again.
const MOST_ROUNDS: usize = 5;
/// Interval at which the queue is examined.
const INTERVAL: Duration = Duration::from_secs(1);
/// Failures of `squeue` one after another that are waited out: the controller may be started again.
const MOST_FAILURES: usize = 600;

/// A study that a cluster carries out.
#[derive(Clone, Copy, Debug)]
pub struct Cluster<'c> {
    /// The command line of the study, the program first, without shard.
    pub command: &'c [OsString],
    /// The table; shards and logs are written beside it, in a folder that all nodes see.
    pub table: &'c Path,
    /// Number of shards. It stands in the job script: the array may have only those that are missing.
    pub shards: u64,
    /// Further options of `sbatch`, such as `--partition=long`.
    pub options: &'c [String],
}

impl Cluster<'_> {
    /// Submits the shards that are missing and waits for them, until all are there; `progress` receives how many are.
    ///
    /// # Errors
    /// `sbatch` that is not there or refuses the job; shards that were lost again and again, with the log of one.
    pub fn run(&self, progress: &dyn Fn(u64)) -> Result<(), StudyError> {
        for _ in 0..MOST_ROUNDS {
            let missing = self.missing();
            progress(self.shards - missing.len() as u64);
            if missing.is_empty() {
                return Ok(());
            }
            let job = self.submit(&missing)?;
            let mut failures = 0;
            loop {
                thread::sleep(INTERVAL);
                let missing = self.missing();
                progress(self.shards - missing.len() as u64);
                // The queue may keep tasks of a node that died after their shards were written.
                if missing.is_empty() {
                    return Ok(());
                }
                match is_queued(&job) {
                    Some(true) => failures = 0,
                    Some(false) => break,
                    None if failures < MOST_FAILURES => failures += 1,
                    None => {
                        let why = Text::new(
                            "squeue does not answer; job {job} may still run: start the same command again later",
                        );
                        return Err(StudyError::Unfit(why.with("job", &job)));
                    }
                }
            }
        }
        let missing = self.missing();
        let Some(first) = missing.first() else { return Ok(()) };
        let why = Text::new("shards were lost {times} times: {missing}; see {log}")
            .with("times", MOST_ROUNDS)
            .with("log", self.log(&first.number.to_string()).display())
            .with(
                "missing",
                missing.iter().map(|shard| shard.number.to_string()).collect::<Vec<_>>().join(", "),
            );
        Err(StudyError::Unfit(why))
    }

    /// The shards whose files are not there.
    fn missing(&self) -> Vec<Shard> {
        let all = (1..=self.shards).map(|number| Shard { number, of: self.shards });
        all.filter(|shard| !shard.path(self.table).is_file()).collect()
    }

    /// The log of a task of the array.
    fn log(&self, task: &str) -> PathBuf {
        let mut name = self.table.as_os_str().to_owned();
        name.push(format!(".slurm-{task}.log"));
        PathBuf::from(name)
    }

    /// Submits shards; the number of the job.
    fn submit(&self, shards: &[Shard]) -> Result<String, StudyError> {
        let numbers: Vec<String> = shards.iter().map(|shard| shard.number.to_string()).collect();
        let mut command = Command::new("sbatch");
        command
            .arg("--parsable")
            .arg("--job-name=dalembert-study")
            .arg(format!("--array={}", numbers.join(",")))
            .arg(joined("--output=", self.log("%a").as_os_str()))
            .args(self.options)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| {
            let why = Text::new("sbatch: {why}; run this on a machine of the cluster");
            StudyError::Unfit(why.with("why", error))
        })?;
        if let Some(mut stdin) = child.stdin.take() {
            // A job that is refused before it is read has its reason on the error stream.
            let _ = stdin.write_all(self.script().as_encoded_bytes());
        }
        let output = child.wait_with_output().map_err(StudyError::of_file("sbatch"))?;
        let said = |text: &[u8]| String::from_utf8_lossy(text).trim().to_owned();
        if !output.status.success() {
            let why = Text::new("sbatch refuses the job: {why}").with("why", said(&output.stderr));
            return Err(StudyError::Unfit(why));
        }
        // `job` or `job;cluster`.
        let printed = said(&output.stdout);
        Ok(printed.split(';').next().unwrap_or_default().to_owned())
    }

    /// The job script.
    fn script(&self) -> OsString {
        let mut script = OsString::from("#!/bin/sh\nexec");
        for word in self.command {
            script.push(" ");
            script.push(quoted(word));
        }
        script.push(format!(
            " --shard \"$SLURM_ARRAY_TASK_ID/{}\" --threads \"${{SLURM_CPUS_PER_TASK:-1}}\" > /dev/null\n",
            self.shards
        ));
        script
    }
}

/// Returns true while a job waits or runs; `None` where the queue does not answer.
fn is_queued(job: &str) -> Option<bool> {
    let Output { status, stdout, stderr } = Command::new("squeue").args(["-h", "-j", job]).output().ok()?;
    if status.success() {
        return Some(!stdout.trim_ascii().is_empty());
    }
    // A job that has left the queue some time ago is not known any more.
    String::from_utf8_lossy(&stderr).contains("Invalid job id").then_some(false)
}

/// A word of a shell.
fn quoted(word: &OsStr) -> OsString {
    let parts: Vec<&[u8]> = word.as_encoded_bytes().split(|byte| *byte == b'\'').collect();
    let text = parts.join(&b"'\\''"[..]);
    let text = String::from_utf8_lossy(&text).into_owned();
    joined("'", OsStr::new(&format!("{text}'")))
}

fn joined(before: &str, word: &OsStr) -> OsString {
    let mut text = OsString::from(before);
    text.push(word);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_job_script_are_quoted() {
        let command =
            ["/opt/dalembert", "study", "it's.toml", "--vary", "mass=normal(2 %)"].map(OsString::from);
        let cluster =
            Cluster { command: &command, table: Path::new("out/table.csv"), shards: 16, options: &[] };
        assert_eq!(
            cluster.script().to_string_lossy(),
            "#!/bin/sh\nexec '/opt/dalembert' 'study' 'it'\\''s.toml' '--vary' 'mass=normal(2 %)' --shard \
             \"$SLURM_ARRAY_TASK_ID/16\" --threads \"${SLURM_CPUS_PER_TASK:-1}\" > /dev/null\n"
        );
        assert_eq!(cluster.log("3"), Path::new("out/table.csv.slurm-3.log"));
        assert_eq!(cluster.missing().len(), 16);
    }
}
