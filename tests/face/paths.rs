//! The paths that a source file names, however it names them: in `use` and `extern crate`, under another name, in types and expressions, inside macro calls.

use std::{fs, path::Path};

use syn::{
    Attribute, Ident, Item, Macro, Token, UseTree, Visibility, braced, bracketed,
    ext::IdentExt,
    parenthesized,
    parse::{Parse, ParseStream},
    token,
    visit::{self, Visit},
};

/// All paths in a file, but for those in its tests, which may use what they like.
#[derive(Default)]
pub struct Paths {
    /// Segment by segment. A name alone is a path only where it is imported: elsewhere it is a local name.
    pub found: Vec<Vec<String>>,
    /// Those of `pub use`.
    pub re_exported: Vec<Vec<String>>,
}

impl Paths {
    /// The paths in a file.
    pub fn of_file(path: &Path) -> Self {
        Self::of(&fs::read_to_string(path).unwrap())
    }

    /// The paths in a text.
    pub fn of(text: &str) -> Self {
        let mut paths = Self::default();
        paths.visit_file(&syn::parse_file(text).unwrap());
        paths
    }

    fn add(&mut self, path: Vec<String>) {
        if path.len() > 1 {
            self.found.push(path);
        }
    }
}

/// What a tree of `use` names, behind the segments `before` it.
fn leaves(before: &[String], tree: &UseTree, found: &mut Vec<Vec<String>>) {
    let with = |ident: &Ident| [before, &[ident.to_string()]].concat();
    match tree {
        UseTree::Path(path) => leaves(&with(&path.ident), &path.tree, found),
        UseTree::Name(name) => found.push(with(&name.ident)),
        UseTree::Rename(name) => found.push(with(&name.ident)),
        UseTree::Glob(_) => found.push(before.to_vec()),
        UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(before, tree, found)),
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.parse_args::<syn::Ident>().is_ok_and(|condition| condition == "test")
    })
}

impl<'ast> Visit<'ast> for Paths {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Mod(module) if is_test(&module.attrs) => {}
            Item::ExternCrate(item) => self.found.push(vec![item.ident.to_string()]),
            Item::Use(item) => {
                let mut named = Vec::new();
                leaves(&[], &item.tree, &mut named);
                if !matches!(item.vis, Visibility::Inherited) {
                    self.re_exported.extend(named.iter().cloned());
                }
                self.found.extend(named);
            }
            _ => visit::visit_item(self, item),
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.add(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        let InMacro(paths) = call.parse_body().unwrap();
        paths.into_iter().for_each(|path| self.add(path));
        visit::visit_macro(self, call);
    }
}

/// The runs `a::b::c` among the tokens of a macro call.
struct InMacro(Vec<Vec<String>>);

impl Parse for InMacro {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let mut found = Vec::new();
        while !input.is_empty() {
            if input.peek(Ident::peek_any) {
                let mut path = vec![input.call(Ident::parse_any)?.to_string()];
                while input.peek(Token![::]) && input.peek3(Ident::peek_any) {
                    input.parse::<Token![::]>()?;
                    path.push(input.call(Ident::parse_any)?.to_string());
                }
                found.push(path);
                continue;
            }
            let inside;
            if input.peek(token::Paren) {
                parenthesized!(inside in input);
            } else if input.peek(token::Brace) {
                braced!(inside in input);
            } else if input.peek(token::Bracket) {
                bracketed!(inside in input);
            } else {
                input.step(|cursor| Ok(((), cursor.token_tree().map_or(*cursor, |(_, rest)| rest))))?;
                continue;
            }
            found.extend(inside.call(Self::parse)?.0);
        }
        Ok(Self(found))
    }
}

#[test]
fn every_way_to_name_a_crate_is_seen() {
    for text in [
        "use ode;",
        "use ode as x;",
        "use {ode as x};",
        "use ::ode::{Ode as Other};",
        "use ode::*;",
        "extern crate ode as x;",
        "fn f() -> ode::Ode { loop {} }",
        "fn f() { let x = ode::Ode::new(); }",
        "fn f(x: Box<dyn Fn(ode::Ode)>) {}",
        "fn f() { use ode::Ode; }",
        "fn f() { println!(\"{}\", [g(ode::Ode::new(1))]); }",
        "fn f() { vec![Some(<ode::Ode>::new())]; }",
        "macro_rules! f { () => { ode::Ode::new() } }",
    ] {
        let paths = Paths::of(text).found;
        assert!(paths.iter().any(|path| path.first().is_some_and(|first| first == "ode")), "{text}: {paths:?}");
    }
    for text in [
        "fn f(ode: u8) -> u8 { println!(\"{}\", ode); ode }",
        "use crate::ode::Ode;",
        "fn f() { let x = crate::ode::f(); assert!(self::ode::g()) }",
        "/// [`ode::Ode`]\nfn f() {}",
        "#[cfg(test)] mod tests { use ode::Ode; }",
    ] {
        let paths = Paths::of(text).found;
        assert!(!paths.iter().any(|path| path.first().is_some_and(|first| first == "ode")), "{text}: {paths:?}");
    }
    assert_eq!(Paths::of("pub use ode::{a, b}; use taylor::c;").re_exported, [["ode", "a"], ["ode", "b"]]);
}
