//! Small working engines to begin with, one for each of a few languages: a file without dependencies, and its manifest.

/// An engine to begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Starter {
    /// The language, as the command line names it.
    pub language: &'static str,
    /// The name of its file.
    pub file: &'static str,
    /// What is in it.
    pub text: &'static str,
    /// The command that builds it, if it has to be.
    pub build: Option<&'static str>,
    /// The command that runs it, as the manifest has it.
    run: &'static str,
    /// The command that tells what it was run or built by, as the manifest has it.
    version: &'static str,
}

/// Every starter.
pub const ALL: [Starter; 6] = [
    Starter {
        language: "python",
        file: "engine.py",
        text: include_str!("starters/python/engine.py"),
        build: None,
        run: r#"["python3", "engine.py"]"#,
        version: r#"["python3", "--version"]"#,
    },
    Starter {
        language: "c",
        file: "engine.c",
        text: include_str!("starters/c/engine.c"),
        build: Some("cc -O2 -o engine engine.c -lm"),
        run: r#"["./engine"]"#,
        version: r#"["cc", "--version"]"#,
    },
    Starter {
        language: "cpp",
        file: "engine.cpp",
        text: include_str!("starters/cpp/engine.cpp"),
        build: Some("c++ -std=c++17 -O2 -o engine engine.cpp"),
        run: r#"["./engine"]"#,
        version: r#"["c++", "--version"]"#,
    },
    Starter {
        language: "julia",
        file: "engine.jl",
        text: include_str!("starters/julia/engine.jl"),
        build: None,
        run: r#"["julia", "--startup-file=no", "engine.jl"]"#,
        version: r#"["julia", "--version"]"#,
    },
    Starter {
        language: "octave",
        file: "engine.m",
        text: include_str!("starters/octave/engine.m"),
        build: None,
        run: r#"["octave-cli", "--quiet", "--no-init-file", "--no-line-editing", "engine.m"]"#,
        version: r#"["octave-cli", "--version"]"#,
    },
    Starter {
        language: "rust",
        file: "engine.rs",
        text: include_str!("starters/rust/engine.rs"),
        build: Some("rustc -O engine.rs"),
        run: r#"["./engine"]"#,
        version: r#"["rustc", "--version"]"#,
    },
];

impl Starter {
    /// The starter in this language.
    pub fn named(language: &str) -> Option<&'static Self> {
        ALL.iter().find(|starter| starter.language == language)
    }

    /// Its manifest.
    pub fn manifest(&self) -> String {
        let build = self.build.map_or_else(String::new, |build| format!("# Build it first: {build}\n"));
        let text = include_str!("starters/engines.toml");
        text.replace("LANGUAGE", self.language)
            .replace("# BUILD\n", &build)
            .replace("[RUN]", self.run)
            .replace("[VERSION]", self.version)
    }
}
