//! Files of Windows: who may read a file is the folder's concern, and the folders of a profile are its owner's.

use std::{
    env,
    fs::{self, File, FileType, Metadata},
    io,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use crate::files::{FileError, failed};

/// Opens a file to be read.
pub(in crate::files) fn open(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// Name of what is neither a file nor a folder.
pub(in crate::files) fn kind(_: FileType) -> &'static str {
    "device"
}

/// True if the user may write to a file.
pub(in crate::files) fn is_writable(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| !metadata.permissions().readonly())
}

/// Permissions of a new file: those of its folder.
pub(in crate::files) fn begin(_: &mut tempfile::Builder<'_, '_>, _is_private: bool) {}

/// Permissions of the old file: those of the folder, which the new one has.
pub(in crate::files) fn permit(_: &File, _: &Metadata) -> io::Result<()> {
    Ok(())
}

/// Makes the names in a folder durable, which Windows does itself.
pub(in crate::files) fn sync_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// Makes a folder, below the profile of its owner.
pub(in crate::files) fn private_folder(folder: &Path) -> Result<(), FileError> {
    fs::create_dir_all(folder).map_err(failed("make the folder", folder))
}

/// The bytes of a path; what is no Unicode in it is lost.
pub(in crate::files) fn bytes_of(path: &Path) -> Vec<u8> {
    path.to_string_lossy().into_owned().into_bytes()
}

/// The path of bytes that [`bytes_of`] gave.
pub(in crate::files) fn path_of(bytes: Vec<u8>) -> PathBuf {
    let text = String::from_utf8(bytes);
    let text = text.unwrap_or_else(|err| String::from_utf8_lossy(err.as_bytes()).into_owned());
    PathBuf::from(text)
}

/// The name of this machine.
pub(in crate::files) fn host() -> String {
    env::var("COMPUTERNAME").unwrap_or_default()
}

/// Returns true if a process with this number runs, or if that cannot be found out.
pub(in crate::files) fn runs(process: i32) -> bool {
    let filter = format!("PID eq {process}");
    let listed = Command::new("tasklist")
        .args(["/NH", "/FO", "CSV", "/FI", &filter])
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .output();
    listed.map_or(true, |listed| String::from_utf8_lossy(&listed.stdout).contains(&format!("\"{process}\"")))
}

/// Start time of a process, which no program that is always there reports.
pub(in crate::files) fn began(_: &str) -> Option<String> {
    None
}
