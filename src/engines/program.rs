//! Finding the program of an engine before it is started, as the system will.

use std::{
    env,
    ffi::OsStr,
    fs,
    os::unix::fs::PermissionsExt,
    path::{Path, PathBuf},
};

/// What is wrong with the first word of a command that is run in `directory`, if anything. `path` stands for the PATH of the engine's own environment.
pub fn missing(program: &str, directory: &Path, path: Option<&str>) -> Option<String> {
    if program.contains('/') {
        let file = directory.join(program.trim_start_matches("./"));
        let file = file.strip_prefix(".").unwrap_or(&file);
        return match fs::metadata(file) {
            Ok(there) if there.is_file() && is_executable(&there) => None,
            Ok(there) if there.is_file() => Some(format!("{} is not executable (chmod +x)", file.display())),
            Ok(_) => Some(format!("{} is no file", file.display())),
            Err(error) => Some(format!("there is no program {}: {error}", file.display())),
        };
    }
    let path = path.map(Into::into).or_else(|| env::var_os("PATH")).unwrap_or_default();
    let found = folders(&path)
        .any(|folder| fs::metadata(folder.join(program)).is_ok_and(|there| there.is_file() && is_executable(&there)));
    (!found).then(|| format!("there is no program {program:?} in the folders of PATH"))
}

fn folders(path: &OsStr) -> impl Iterator<Item = PathBuf> {
    env::split_paths(path)
}

fn is_executable(there: &fs::Metadata) -> bool {
    there.permissions().mode() & 0o111 != 0
}
