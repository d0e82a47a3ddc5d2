//! Tables of studies in files: written under a name of their own until they are whole, resumed, sharded and merged.

use std::{
    ffi::OsString,
    fs::{self, File, OpenOptions},
    io::{self, BufReader, BufWriter, Read as _, Seek as _, SeekFrom, Write as _},
    ops::Range,
    path::{Path, PathBuf},
};

use dalembert_core::{
    Locale, Stop, Text,
    study::{Accumulator, BLOCK, Study, Summary},
};

use crate::{
    StudyError,
    table::{self, ReadRow},
    workers,
};

/// A part of the points of a study: shard `number` of `of`, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of the shard, counted from 1.
    pub number: u64,
    /// Number of shards.
    pub of: u64,
}

/// Conditions under which a study is carried out.
#[derive(Clone, Copy)]
pub struct Run<'r> {
    /// The study.
    pub study: &'r Study<'r>,
    /// The [fingerprint](table::fingerprint) of its plan and problem.
    pub fingerprint: &'r str,
    /// Threads that solve.
    pub threads: usize,
    /// Language of reasons.
    pub locale: &'r Locale,
    /// Signal to stop.
    pub stop: &'r Stop,
    /// Called with the number of points that are done.
    pub progress: &'r dyn Fn(u64),
}

impl Shard {
    /// Reads `3/16`; `None` where it is no such text.
    pub fn read(text: &str) -> Option<Self> {
        let (number, of) = text.split_once('/')?;
        let shard = Self { number: number.trim().parse().ok()?, of: of.trim().parse().ok()? };
        (shard.number >= 1 && shard.number <= shard.of).then_some(shard)
    }

    /// The points of the shard: whole blocks, as many in each as can be.
    fn range(self, points: u64) -> Range<u64> {
        let block = BLOCK as u64;
        let blocks = u128::from(points.div_ceil(block));
        let end = |n: u64| ((blocks * u128::from(n) / u128::from(self.of)) as u64 * block).min(points);
        end(self.number - 1)..end(self.number)
    }

    /// The file of the shard beside that of the whole table: `table.shard-3-of-16.csv`.
    pub fn path(self, table: &Path) -> PathBuf {
        let mut name = table.file_stem().map_or_else(OsString::new, OsString::from);
        name.push(format!(".shard-{}-of-{}", self.number, self.of));
        if let Some(extension) = table.extension() {
            name.push(".");
            name.push(extension);
        }
        table.with_file_name(name)
    }
}

impl Run<'_> {
    /// Solves all points without writing a table.
    ///
    /// # Errors
    /// [`StudyError::Solve`] once stopped.
    pub fn summarise(&self) -> Result<Summary, StudyError> {
        let mut sums = self.study.accumulator(0);
        let points = self.study.design.points();
        self.solve(0..points, 0, &mut sums, None)?;
        Ok(sums.summary())
    }

    /// Solves all points, or those of a shard, into a table, and goes on with one that was broken off. Until it is whole
    /// its name ends in `.part`.
    ///
    /// # Errors
    /// A file that cannot be read or written; a begun table of another plan, or one that another process is writing;
    /// [`StudyError::Solve`] once stopped.
    pub fn write(&self, table: &Path, shard: Option<Shard>) -> Result<Summary, StudyError> {
        let path = shard.map_or_else(|| table.to_owned(), |shard| shard.path(table));
        let points = self.study.design.points();
        let range = shard.map_or(0..points, |shard| shard.range(points));
        let header = table::header(self.study, self.fingerprint, shard.map(|shard| (shard.number, shard.of)));
        let mut part = Part::open(&path, &header)?;
        let mut sums = self.study.accumulator(range.start);
        let done = part.resume(&header, &mut |row| self.push(row, &mut sums), self.numbers())?;
        let from = range.start + done;
        if from > range.end {
            return Err(foreign(&part.path));
        }
        self.solve(from..range.end, done, &mut sums, Some(&mut part))?;
        part.finish(&path)?;
        Ok(sums.summary())
    }

    /// The statistics of a table or a shard that is whole.
    ///
    /// # Errors
    /// A file that cannot be read, or is of another plan.
    pub fn read(&self, path: &Path, shard: Option<Shard>) -> Result<Summary, StudyError> {
        let points = self.study.design.points();
        let mut sums = self.study.accumulator(shard.map_or(0, |shard| shard.range(points).start));
        self.rows(path, shard, &mut |row| self.push(row, &mut sums))?;
        Ok(sums.summary())
    }

    /// Hands on the rows of a table or a shard that is whole.
    ///
    /// # Errors
    /// A file that cannot be read, or is of another plan.
    pub fn rows(
        &self,
        path: &Path,
        shard: Option<Shard>,
        take: &mut dyn FnMut(&ReadRow),
    ) -> Result<(), StudyError> {
        let header = table::header(self.study, self.fingerprint, shard.map(|shard| (shard.number, shard.of)));
        let file = File::open(path).map_err(StudyError::of_file(path))?;
        read_rows(&mut below(file, &header, path)?, self.numbers(), path, take).map(drop)
    }

    /// Merges the shards beside a table into it.
    ///
    /// # Errors
    /// A file that cannot be read or written; shards that are missing, of another plan, or of another number.
    pub fn merge(&self, table: &Path) -> Result<Summary, StudyError> {
        let of = shards_beside(table)?;
        let shards: Vec<Shard> = (1..=of).map(|number| Shard { number, of }).collect();
        let missing: Vec<String> = shards
            .iter()
            .filter(|shard| !shard.path(table).is_file())
            .map(|shard| format!("{}/{of}", shard.number))
            .collect();
        if !missing.is_empty() {
            let why =
                Text::new("shards are missing: {missing}; run each with --shard, as in --shard {first}");
            let why = why.with("first", &missing[0]).with("missing", missing.join(", "));
            return Err(StudyError::Unfit(why));
        }
        let header = table::header(self.study, self.fingerprint, None);
        let mut part = Part::open(table, &header)?;
        part.restart(&header)?;
        let mut sums = self.study.accumulator(0);
        let points = self.study.design.points();
        for shard in shards {
            let path = shard.path(table);
            let own = table::header(self.study, self.fingerprint, Some((shard.number, of)));
            let file = File::open(&path).map_err(StudyError::of_file(&path))?;
            let mut rows = below(file, &own, &path)?;
            let at = rows.stream_position().map_err(StudyError::of_file(&path))?;
            let rows_read =
                read_rows(&mut rows, self.numbers(), &path, &mut |row| self.push(row, &mut sums))?;
            let range = shard.range(points);
            if rows_read != range.end - range.start {
                return Err(foreign(&path));
            }
            rows.seek(SeekFrom::Start(at)).map_err(StudyError::of_file(&path))?;
            io::copy(&mut rows, &mut part.file).map_err(StudyError::of_file(&part.path))?;
            (self.progress)(range.end);
        }
        part.finish(table)?;
        Ok(sums.summary())
    }

    /// Numbers of a row.
    fn numbers(&self) -> usize {
        self.study.design.inputs.len() + self.study.answers.len()
    }

    fn push(&self, row: &ReadRow, sums: &mut Accumulator) {
        let (inputs, answers) = row.numbers.split_at(self.study.design.inputs.len());
        sums.push(inputs, answers, row.refusal.as_ref());
    }

    fn solve(
        &self,
        range: Range<u64>,
        mut done: u64,
        sums: &mut Accumulator,
        mut part: Option<&mut Part>,
    ) -> Result<(), StudyError> {
        let locale = part.is_some().then_some(self.locale);
        (self.progress)(done);
        workers::solve(self.study, range, self.threads, locale, self.stop, &mut |block| {
            sums.take(&block.rows);
            done += block.rows.len() as u64;
            if let Some(part) = &mut part {
                part.write(&block.text)?;
            }
            (self.progress)(done);
            Ok(())
        })
    }
}

/// A table that is not whole yet.
struct Part {
    path: PathBuf,
    file: BufWriter<File>,
}

impl Part {
    /// Opens the file of a table that is being written, or begins one.
    fn open(table: &Path, header: &str) -> Result<Self, StudyError> {
        let mut name = table.as_os_str().to_owned();
        name.push(".part");
        let path = PathBuf::from(name);
        let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
        let file = opened.map_err(StudyError::of_file(&path))?;
        if file.try_lock().is_err() {
            let why = Text::new("{file} is being written by another process; wait for it or stop it");
            return Err(StudyError::Unfit(why.with("file", path.display())));
        }
        let mut part = Self { path, file: BufWriter::with_capacity(1 << 20, file) };
        let length = part.file.get_ref().metadata().map_err(StudyError::of_file(&part.path))?.len();
        // What ends within its header has no rows.
        if length < header.len() as u64 {
            part.restart(header)?;
        }
        Ok(part)
    }

    /// Begins the table anew.
    fn restart(&mut self, header: &str) -> Result<(), StudyError> {
        let file = &mut self.file;
        let begun = file.get_mut().set_len(0).and_then(|()| file.seek(SeekFrom::Start(0)));
        let begun = begun.and_then(|_| file.write_all(header.as_bytes())).and_then(|()| file.flush());
        begun.map_err(StudyError::of_file(&self.path))
    }

    /// Reads the rows that are there, and cuts off one that was not finished. The number of rows.
    fn resume(
        &mut self,
        header: &str,
        take: &mut dyn FnMut(&ReadRow),
        numbers: usize,
    ) -> Result<u64, StudyError> {
        let path = self.path.clone();
        let whole = whole_lines(self.file.get_mut()).map_err(StudyError::of_file(&path))?;
        self.file.get_mut().set_len(whole).map_err(StudyError::of_file(&path))?;
        let file = self.file.get_ref().try_clone().map_err(StudyError::of_file(&path))?;
        let mut rows = below(file, header, &path)?;
        let done = read_rows(&mut rows, numbers, &path, take)?;
        self.file.seek(SeekFrom::End(0)).map_err(StudyError::of_file(&path))?;
        Ok(done)
    }

    fn write(&mut self, text: &str) -> Result<(), StudyError> {
        // Every block is with the system once it is written: a process that is killed loses nothing more.
        let written = self.file.write_all(text.as_bytes()).and_then(|()| self.file.flush());
        written.map_err(StudyError::of_file(&self.path))
    }

    /// Gives the whole table its name.
    fn finish(mut self, table: &Path) -> Result<(), StudyError> {
        let done = self.file.flush().and_then(|()| self.file.get_ref().sync_all());
        done.map_err(StudyError::of_file(&self.path))?;
        fs::rename(&self.path, table).map_err(StudyError::of_file(table))
    }
}

/// The length of a file up to the end of its last whole line.
fn whole_lines(file: &mut File) -> io::Result<u64> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut buffer = [0; 4096];
    while end > 0 {
        let from = end.saturating_sub(buffer.len() as u64);
        let here = &mut buffer[..(end - from) as usize];
        file.seek(SeekFrom::Start(from))?;
        file.read_exact(here)?;
        if let Some(at) = here.iter().rposition(|byte| *byte == b'\n') {
            return Ok(from + at as u64 + 1);
        }
        end = from;
    }
    Ok(0)
}

/// The rows of a file below its header, which must be this one.
fn below(mut file: File, header: &str, path: &Path) -> Result<BufReader<File>, StudyError> {
    let mut own = vec![0; header.len()];
    let read = file.seek(SeekFrom::Start(0)).and_then(|_| file.read_exact(&mut own));
    match read {
        Ok(()) if own == header.as_bytes() => Ok(BufReader::with_capacity(1 << 16, file)),
        Err(error) if error.kind() != io::ErrorKind::UnexpectedEof => Err(StudyError::of_file(path)(error)),
        _ => Err(foreign(path)),
    }
}

/// Reads all rows of so many numbers; how many there are.
fn read_rows(
    rows: &mut BufReader<File>,
    numbers: usize,
    path: &Path,
    take: &mut dyn FnMut(&ReadRow),
) -> Result<u64, StudyError> {
    let mut reader = table::rows_of(rows);
    let mut record = csv::StringRecord::new();
    let mut row = ReadRow::default();
    let mut count = 0;
    while reader.read_record(&mut record).map_err(|_| foreign(path))? {
        table::read_row(&record, numbers, &mut row).ok_or_else(|| foreign(path))?;
        take(&row);
        count += 1;
    }
    Ok(count)
}

/// Refusal of a file that is not of this study.
fn foreign(path: &Path) -> StudyError {
    let why = Text::new(
        "{file} is of another plan, problem or version of the program; delete it or choose another name",
    );
    StudyError::Unfit(why.with("file", path.display()))
}

/// The number of shards beside a table, by their names.
fn shards_beside(table: &Path) -> Result<u64, StudyError> {
    let folder = match table.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let entries = fs::read_dir(folder).map_err(StudyError::of_file(folder))?;
    let mut numbers: Vec<u64> = Vec::new();
    for entry in entries {
        let name = entry.map_err(StudyError::of_file(folder))?.file_name();
        let name = name.to_string_lossy().into_owned();
        let number = name.split_once(".shard-").and_then(|(_, rest)| rest.split_once("-of-"));
        let Some((number, of)) = number else { continue };
        let of = of.split('.').next().unwrap_or(of);
        if let Some(shard) = Shard::read(&format!("{number}/{of}"))
            && shard.path(table).file_name().is_some_and(|own| own.to_string_lossy() == name)
        {
            numbers.push(shard.of);
        }
    }
    numbers.sort_unstable();
    numbers.dedup();
    match numbers[..] {
        [of] => Ok(of),
        [] => {
            let why = Text::new("there are no shards of {file}; run them with --shard, as in --shard 1/4");
            Err(StudyError::Unfit(why.with("file", table.display())))
        }
        _ => {
            let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
            let why = Text::new("beside {file} there are shards of {numbers}; keep those of one number");
            Err(StudyError::Unfit(why.with("file", table.display()).with("numbers", numbers.join(", "))))
        }
    }
}
