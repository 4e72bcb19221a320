//! The names that a crate defines, read from its sources: modules, items, and the methods, fields and
//! variants of types, as they can be reached from inside and from outside.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use syn::{Attribute, Fields, ImplItem, Item, TraitItem, Type, UseTree, Visibility};

/// A path without the crate in front, such as `article::eq_46`; empty for the crate itself.
type Name = String;

/// What a type or trait holds, and whether it is public.
type Members = Vec<(String, bool)>;

pub struct Names {
    /// Folder of the crate.
    root: PathBuf,
    /// What each module holds. A function may have the name of a module, so that a name has several entries.
    modules: HashMap<Name, Vec<Entry>>,
    members: HashMap<Name, Members>,
    impls: Vec<Impl>,
}

/// An `impl` block.
struct Impl {
    /// The module it stands in.
    module: Name,
    /// The type as it is called there.
    of: Vec<String>,
    members: Members,
}

struct Entry {
    name: String,
    public: bool,
    target: Target,
}

#[derive(Clone)]
enum Target {
    Module(Name),
    Item(Name),
    Member,
    /// Another name for what this path means in this module.
    Use(Name, Vec<String>),
}

/// No name is handed on through so many `use`s; those that name themselves end here.
const MOST_USES: u32 = 8;

impl Names {
    /// The names of the crate in this folder.
    pub fn of(root: &Path) -> Self {
        let mut names = Names {
            root: root.into(),
            modules: HashMap::new(),
            members: HashMap::new(),
            impls: Vec::new(),
        };
        let file = root.join("src/lib.rs");
        names.add_module("", parse(&file).items, &root.join("src"));
        for Impl { module, of, members } in std::mem::take(&mut names.impls) {
            for target in names.find(&module, &of, false, 0) {
                if let Target::Item(name) = target {
                    names.members.entry(name).or_default().extend(members.clone());
                }
            }
        }
        names
    }

    /// Whether there is such a name: public, inside if it begins with `crate::`, or a file and a test in it.
    pub fn check(&self, name: &str) -> Result<(), String> {
        if name.contains('/') {
            return self.check_file(name);
        }
        let (path, public) = match name.strip_prefix("crate::") {
            Some(path) => (path, false),
            None => (name, true),
        };
        let path: Vec<String> = path.split("::").map(Into::into).collect();
        for length in 1..=path.len() {
            if self.find("", &path[..length], public, 0).is_empty() {
                let holder = match &path[..length - 1] {
                    [] => "the crate".to_owned(),
                    holder => format!("`{}`", holder.join("::")),
                };
                let public = if public { "public " } else { "" };
                return Err(format!("{holder} has no {public}`{}`", path[length - 1]));
            }
        }
        Ok(())
    }

    /// The public names in a module, and those that its types and traits hold.
    pub fn public_below(&self, module: &str) -> Vec<Name> {
        let mut found = Vec::new();
        for entry in self.modules[module].iter().filter(|entry| entry.public) {
            let name = format!("{module}::{}", entry.name);
            for target in self.find(module, std::slice::from_ref(&entry.name), true, 0) {
                let Target::Item(item) = target else { continue };
                let members = self.members.get(&item).into_iter().flatten();
                let public = members.filter(|(_, public)| *public);
                found.extend(public.map(|(member, _)| format!("{name}::{member}")));
            }
            found.push(name);
        }
        found
    }

    fn check_file(&self, name: &str) -> Result<(), String> {
        let mut parts = name.split("::");
        let file = self.root.join(parts.next().unwrap_or_default());
        if !file.is_file() {
            return Err("no such file".into());
        }
        let path: Vec<&str> = parts.collect();
        if path.is_empty() || has_test(&parse(&file).items, &path) {
            return Ok(());
        }
        Err("no such test in this file".into())
    }

    /// All that a path can mean in a module.
    fn find(&self, module: &str, path: &[String], public: bool, uses: u32) -> Vec<Target> {
        let Some((first, rest)) = path.split_first() else {
            return vec![Target::Module(module.into())];
        };
        let mut found = Vec::new();
        let entries = self.modules[module].iter();
        for entry in entries.filter(|entry| entry.name == *first && (entry.public || !public)) {
            let targets = match &entry.target {
                Target::Use(..) if uses == MOST_USES => Vec::new(),
                // What is handed on need not be public where it comes from.
                Target::Use(from, path) => self.find(from, path, false, uses + 1),
                target => vec![target.clone()],
            };
            for target in targets {
                match target {
                    Target::Module(inner) => found.extend(self.find(&inner, rest, public, uses)),
                    target if rest.is_empty() => found.push(target),
                    Target::Item(item)
                        if rest.len() == 1 && self.holds(&item, &rest[0], public) =>
                    {
                        found.push(Target::Member);
                    }
                    _ => {}
                }
            }
        }
        found
    }

    fn holds(&self, item: &str, member: &str, public: bool) -> bool {
        let mut members = self.members.get(item).into_iter().flatten();
        members.any(|(name, is_public)| name == member && (*is_public || !public))
    }

    /// Takes in a module; `folder` is where the files of its own modules lie.
    fn add_module(&mut self, module: &str, items: Vec<Item>, folder: &Path) {
        self.modules.entry(module.into()).or_default();
        for item in items {
            self.add_item(module, item, folder);
        }
    }

    fn add_item(&mut self, module: &str, item: Item, folder: &Path) {
        let mut add = |name: &syn::Ident, vis: &Visibility, members: Members| {
            let full = below(module, &name.to_string());
            self.members.entry(full.clone()).or_default().extend(members);
            self.add_entry(module, name.to_string(), is_public(vis), Target::Item(full));
        };
        match item {
            Item::Fn(item) => add(&item.sig.ident, &item.vis, Vec::new()),
            Item::Const(item) => add(&item.ident, &item.vis, Vec::new()),
            Item::Static(item) => add(&item.ident, &item.vis, Vec::new()),
            Item::Type(item) => add(&item.ident, &item.vis, Vec::new()),
            Item::Struct(item) => add(&item.ident, &item.vis, fields(&item.fields)),
            Item::Enum(item) => {
                let variant = |variant: &syn::Variant| (variant.ident.to_string(), true);
                add(&item.ident, &item.vis, item.variants.iter().map(variant).collect());
            }
            Item::Trait(item) => {
                let held = item.items.iter().filter_map(|item| match item {
                    TraitItem::Fn(method) => Some((method.sig.ident.to_string(), true)),
                    _ => None,
                });
                add(&item.ident, &item.vis, held.collect());
            }
            Item::Impl(item) => {
                let Type::Path(of) = &*item.self_ty else { return };
                let of = of.path.segments.iter().map(|part| part.ident.to_string()).collect();
                let of_trait = item.trait_.is_some();
                let held = item.items.iter().filter_map(|item| match item {
                    ImplItem::Fn(method) => Some((&method.sig.ident, &method.vis)),
                    ImplItem::Const(constant) => Some((&constant.ident, &constant.vis)),
                    _ => None,
                });
                let held = held.map(|(name, vis)| (name.to_string(), of_trait || is_public(vis)));
                self.impls.push(Impl { module: module.into(), of, members: held.collect() });
            }
            Item::Use(item) => {
                self.add_use(module, module, &mut Vec::new(), &item.tree, is_public(&item.vis));
            }
            Item::Mod(item) if !is_conditional(&item.attrs) => {
                let name = item.ident.to_string();
                let (full, inner) = (below(module, &name), folder.join(&name));
                let items = match item.content {
                    Some((_, items)) => items,
                    None => parse(&file_of(&inner)).items,
                };
                self.add_module(&full, items, &inner);
                self.add_entry(module, name, is_public(&item.vis), Target::Module(full));
            }
            _ => {}
        }
    }

    /// Takes in `use from::path::tree` of a module. What comes from other crates is found nowhere later on.
    fn add_use(
        &mut self,
        module: &str,
        from: &str,
        path: &mut Vec<String>,
        tree: &UseTree,
        public: bool,
    ) {
        let (name, last) = match tree {
            UseTree::Path(part) => {
                let parent = || from.rsplit_once("::").map_or("", |(parent, _)| parent).to_owned();
                let (from, named) = match part.ident.to_string().as_str() {
                    "crate" => (String::new(), None),
                    "self" => (from.into(), None),
                    "super" => (parent(), None),
                    name => (from.into(), Some(name.to_owned())),
                };
                let length = path.len();
                path.extend(named);
                self.add_use(module, &from, path, &part.tree, public);
                path.truncate(length);
                return;
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.add_use(module, from, path, tree, public);
                }
                return;
            }
            UseTree::Name(name) => (name.ident.to_string(), name.ident.to_string()),
            UseTree::Rename(rename) => (rename.rename.to_string(), rename.ident.to_string()),
            UseTree::Glob(_) => panic!("`use` with * in {module:?}: this reader does not know it"),
        };
        let whole = path.iter().cloned().chain((last != "self").then_some(last)).collect();
        let name = if name == "self" { path.last().cloned().unwrap_or_default() } else { name };
        self.add_entry(module, name, public, Target::Use(from.into(), whole));
    }

    fn add_entry(&mut self, module: &str, name: String, public: bool, target: Target) {
        self.modules.entry(module.into()).or_default().push(Entry { name, public, target });
    }
}

/// Whether these items hold a test function at this path.
fn has_test(items: &[Item], path: &[&str]) -> bool {
    let Some((first, rest)) = path.split_first() else { return false };
    items.iter().any(|item| match item {
        Item::Fn(function) => {
            let is_test = function.attrs.iter().any(|attribute| attribute.path().is_ident("test"));
            rest.is_empty() && function.sig.ident == first && is_test
        }
        Item::Mod(module) if module.ident == first => {
            module.content.as_ref().is_some_and(|(_, items)| has_test(items, rest))
        }
        _ => false,
    })
}

fn fields(fields: &Fields) -> Members {
    let named = fields.iter().filter_map(|field| Some((field.ident.as_ref()?, &field.vis)));
    named.map(|(name, vis)| (name.to_string(), is_public(vis))).collect()
}

fn is_public(vis: &Visibility) -> bool {
    matches!(vis, Visibility::Public(_))
}

/// Whether it is there for some builds only, as unit tests are.
fn is_conditional(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("cfg"))
}

fn below(module: &str, name: &str) -> Name {
    if module.is_empty() { name.into() } else { format!("{module}::{name}") }
}

/// The file of the module whose own modules lie in `folder`.
fn file_of(folder: &Path) -> PathBuf {
    let alone = folder.with_extension("rs");
    if alone.is_file() { alone } else { folder.join("mod.rs") }
}

fn parse(file: &Path) -> syn::File {
    let text =
        fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}
