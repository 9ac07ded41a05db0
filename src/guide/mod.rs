//! The guide: how the gate works, how to use it, and what was measured with it. Its Rust examples run as tests.
//!
//! - The gate: [how a verdict comes about](gate), [the judge](judge), [reading a red run](red), [what the gate catches](detection),
//!   [expected divergences](divergences), [where cases come from](cases), [a run in parts, and in CI](parts).
//! - Using it: [the commands](commands), [a simulator of your own under the gate](engines), [the methods](methods), [scenes in physical units](scenes), [a bookcase in an earthquake](earthquake), [whole responses](responses), [Python](python), [maps](sweep), [the plan](plan).
//! - Theory: [chattering under any motion of the ground](any_motion).
//! - What was found: [where the asymptotics break](asymptotics), [the critical amplitude](critical), [the paper](paper), [how fast it is](speed),
//!   [other tools](peers).
//! - Working on it: [adding a method, a law, a case](add).

/// Links between chapters. Each file defines its own at its foot, which lead to files, for readers of the repository. Where a link is defined twice
/// Markdown takes the first definition: these, which lead to modules.
macro_rules! links {
    () => {
        "\
[gate]: crate::guide::gate
[judge]: crate::guide::judge
[red]: crate::guide::red
[detection]: crate::guide::detection
[divergences]: crate::guide::divergences
[cases]: crate::guide::cases
[parts]: crate::guide::parts
[commands]: crate::guide::commands
[methods]: crate::guide::methods
[engines]: crate::guide::engines
[scenes]: crate::guide::scenes
[earthquake]: crate::guide::earthquake
[responses]: crate::guide::responses
[plan]: crate::guide::plan
[sweep]: crate::guide::sweep
[python]: crate::guide::python
[any_motion]: crate::guide::any_motion
[asymptotics]: crate::guide::asymptotics
[critical]: crate::guide::critical
[paper]: crate::guide::paper
[speed]: crate::guide::speed
[peers]: crate::guide::peers
[add]: crate::guide::add

"
    };
}

/// A chapter, from the file of its name.
macro_rules! chapters {
    ($($name:ident)*) => { $(
        #[doc = links!()]
        #[doc = include_str!(concat!(stringify!($name), ".md"))]
        pub mod $name {}
    )* };
}

chapters! {
    gate judge red detection divergences cases parts
    commands engines methods scenes earthquake responses plan sweep python
    any_motion asymptotics critical paper speed peers
    add
}
