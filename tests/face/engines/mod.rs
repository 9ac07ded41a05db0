//! Engines of others: the starters work as they stand, what is wrong with an engine is said in words, both sides of a talk are shown, and what the gate makes of them.

mod gate;
mod starters;
mod talk;

use std::{fs, path::Path, process::Command};

fn chattercheck(folder: &Path, arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    let output = command.args(arguments.split_whitespace()).current_dir(folder).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// An engine of shell lines, and its manifest.
fn shell(folder: &Path, script: &str, more: &str) {
    fs::write(folder.join("engine.sh"), script).unwrap();
    let manifest = format!("[[engine]]\nname = \"mine\"\nrun = [\"sh\", \"engine.sh\"]\nmodel = \"linear\"\n{more}");
    fs::write(folder.join("engines.toml"), manifest).unwrap();
}

/// Answers the start well, and every case as said.
fn answering(reply: &str) -> String {
    let welcome = r#"{"version":1,"engine":{"name":"mine","version":"1"},"models":["linear"],"normalisations":["threshold"],"ground":["sine"],"echo":[0.1,5e-324,1.7976931348623157e308,-0.0]}"#;
    format!(
        "while read -r line; do seq=${{line#*\\\"seq\\\":}}; seq=${{seq%%,*}}; case $line in *start*versions*) echo '{welcome}';; *stop*) exit;; *) echo \"{{\\\"seq\\\":$seq,{}}}\";; esac; done",
        reply.replace('"', "\\\"")
    )
}
