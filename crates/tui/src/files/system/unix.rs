//! Files of Unix: owner, group, mode.

mod process;

use std::{
    ffi::OsString,
    fs::{self, DirBuilder, File, FileType, Metadata, Permissions},
    io,
    os::unix::{
        ffi::{OsStrExt, OsStringExt},
        fs::{DirBuilderExt, FileTypeExt, MetadataExt, OpenOptionsExt, PermissionsExt},
    },
    path::{Path, PathBuf},
};

use rustix::fs::{Access, Gid, OFlags, Uid, access, fchown};

use crate::files::{FileError, failed, shown};

pub(in crate::files) use process::{began, runs};

/// Opens a file to be read, without waiting for what is a pipe by now.
pub(in crate::files) fn open(path: &Path) -> io::Result<File> {
    File::options().read(true).custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY).bits() as i32).open(path)
}

/// Name of what is neither a file nor a folder.
pub(in crate::files) fn kind(kind: FileType) -> &'static str {
    match kind {
        kind if kind.is_fifo() => "pipe",
        kind if kind.is_socket() => "socket",
        _ => "device",
    }
}

/// True if the user may write to a file.
pub(in crate::files) fn is_writable(path: &Path) -> bool {
    access(path, Access::WRITE_OK).is_ok()
}

/// Permissions of a new file: its owner's alone, or what the umask leaves of everybody's.
pub(in crate::files) fn begin(file: &mut tempfile::Builder<'_, '_>, is_private: bool) {
    // The system takes the umask away.
    file.permissions(Permissions::from_mode(if is_private { 0o600 } else { 0o666 }));
}

/// Gives a new file the owner, the group and the permissions of the old one. Where the system refuses the group, the group
/// that the file has instead may do no more than everybody.
pub(in crate::files) fn permit(file: &File, old: &Metadata) -> io::Result<()> {
    let (owner, group) = (Uid::from_raw(old.uid()), Gid::from_raw(old.gid()));
    let kept = fchown(file, Some(owner), Some(group)).or_else(|_| fchown(file, None, Some(group)));
    let mut mode = old.mode();
    if kept.is_err() && file.metadata()?.gid() != old.gid() {
        mode &= !0o070 | ((mode & 0o007) << 3);
    }
    // After the owner: a change of that takes permissions away.
    file.set_permissions(Permissions::from_mode(mode))
}

/// Makes the names in a folder durable.
pub(in crate::files) fn sync_folder(folder: &Path) -> io::Result<()> {
    match File::open(folder)?.sync_all() {
        // Some file systems cannot; they have their own way.
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => {
            Ok(())
        }
        result => result,
    }
}

/// Makes a folder, for its owner alone, and refuses one that is another's.
pub(in crate::files) fn private_folder(folder: &Path) -> Result<(), FileError> {
    DirBuilder::new()
        .recursive(true)
        .mode(0o700)
        .create(folder)
        .map_err(failed("make the folder", folder))?;
    let metadata = fs::metadata(folder).map_err(failed("open the folder", folder))?;
    if metadata.uid() != rustix::process::geteuid().as_raw() {
        return Err(FileError::NoAutosave(format!("the folder `{}` belongs to another user", shown(folder))));
    }
    if metadata.permissions().mode() & 0o077 != 0 {
        fs::set_permissions(folder, Permissions::from_mode(0o700))
            .map_err(failed("close the folder", folder))?;
    }
    Ok(())
}

/// The bytes of a path.
pub(in crate::files) fn bytes_of(path: &Path) -> Vec<u8> {
    path.as_os_str().as_bytes().to_owned()
}

/// The path of bytes that [`bytes_of`] gave.
pub(in crate::files) fn path_of(bytes: Vec<u8>) -> PathBuf {
    PathBuf::from(OsString::from_vec(bytes))
}

/// The name of this machine: homes of a laboratory are shared, process numbers are not.
pub(in crate::files) fn host() -> String {
    let named =
        fs::read_to_string("/proc/sys/kernel/hostname").or_else(|_| fs::read_to_string("/etc/hostname"));
    named.unwrap_or_default().trim().to_owned()
}
