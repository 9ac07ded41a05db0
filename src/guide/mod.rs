//! The guide: how the gate works, how to use it, and what was measured with it. Its Rust examples run as tests.
//!
//! - The gate: [how a verdict comes about](gate), [the judge](judge), [reading a red run](red), [what the gate catches](detection),
//!   [expected divergences](divergences), [cases](cases).
//! - Using it: [the commands](commands), [the methods](methods), [scenes](scenes), [responses](responses), [the plan](plan).
//! - What was found: [where the asymptotics break](asymptotics), [the critical amplitude](critical), [the paper](paper), [speed](speed),
//!   [other tools](peers).
//! - Working on it: [adding a method, a law, a case](add).

/// Links between chapters. Each file defines its own at its foot, for who reads it there; of two definitions Markdown takes the first,
/// and these lead to the modules.
macro_rules! links {
    () => {
        "\
[gate]: mod@super::gate
[judge]: mod@super::judge
[red]: mod@super::red
[detection]: mod@super::detection
[divergences]: mod@super::divergences
[cases]: mod@super::cases
[commands]: mod@super::commands
[methods]: mod@super::methods
[scenes]: mod@super::scenes
[responses]: mod@super::responses
[plan]: mod@super::plan
[asymptotics]: mod@super::asymptotics
[critical]: mod@super::critical
[paper]: mod@super::paper
[speed]: mod@super::speed
[peers]: mod@super::peers
[add]: mod@super::add

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
    gate judge red detection divergences cases
    commands methods scenes responses plan
    asymptotics critical paper speed peers
    add
}
