//! Both languages say the same things, and the workspace asks for exactly what they say.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use federpendel::parameter::PARAMETERS;
use federpendel_text::{Catalogue, Language};
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser;

/// Texts by id (`id` or `id.attribute`), each with its variables and all its words.
type Texts = BTreeMap<String, (BTreeSet<String>, String)>;

/// The files of a language, in the order of their names.
fn locale(language: Language) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("locales").join(language.tag());
    let entries = fs::read_dir(folder).expect("a folder of locale files");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read_to_string(path).expect("a locale file")).collect()
}

fn texts(language: Language) -> Texts {
    let mut texts = Texts::new();
    for source in locale(language) {
        read(&source, &mut texts);
    }
    texts
}

fn read(source: &str, texts: &mut Texts) {
    let resource = parser::parse(source).expect("the locale file has no syntax error");
    for entry in &resource.body {
        let Entry::Message(message) = entry else { continue };
        let parts = message.value.iter().map(|value| (message.id.name.to_owned(), value)).chain(
            message.attributes.iter().map(|attribute| {
                (format!("{}.{}", message.id.name, attribute.id.name), &attribute.value)
            }),
        );
        for (id, pattern) in parts {
            let mut variables = BTreeSet::new();
            let mut words = String::new();
            walk(pattern, &mut variables, &mut words);
            assert!(texts.insert(id.clone(), (variables, words)).is_none(), "{id} stands twice");
        }
    }
}

fn walk(pattern: &Pattern<&str>, variables: &mut BTreeSet<String>, words: &mut String) {
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => words.push_str(value),
            PatternElement::Placeable { expression } => {
                let (Expression::Inline(inline) | Expression::Select { selector: inline, .. }) =
                    expression;
                if let InlineExpression::VariableReference { id } = inline {
                    variables.insert(id.name.to_owned());
                }
                if let Expression::Select { variants, .. } = expression {
                    for variant in variants {
                        walk(&variant.value, variables, words);
                    }
                }
            }
        }
    }
}

#[test]
fn both_languages_hold_the_same_ids_with_the_same_variables() {
    let english = texts(Language::English);
    let german = texts(Language::German);
    let ids = |texts: &Texts| texts.keys().cloned().collect::<BTreeSet<_>>();
    let (english_ids, german_ids) = (ids(&english), ids(&german));
    let differ: Vec<_> = english_ids.symmetric_difference(&german_ids).collect();
    assert!(differ.is_empty(), "in one language only: {differ:?}");
    for (id, (variables, _)) in &english {
        assert_eq!(variables, &german[id].0, "variables of {id}");
    }
}

#[test]
fn german_is_german() {
    // Words that only English has, and what keyboards without umlauts make of German.
    let foreign = [
        "the",
        "of",
        "is",
        "and",
        "to",
        "from",
        "with",
        "not",
        "must",
        "has",
        "are",
        "swing",
        "friction",
        "rest",
        "fuer",
        "groesser",
        "ueber",
        "daempfung",
        "koerper",
        "ausschliesslich",
        "laesst",
        "moeglich",
        "gueltig",
        "ungueltig",
        "naechste",
    ];
    for (id, (_, words)) in texts(Language::German) {
        for word in words.split(|sign: char| !sign.is_alphabetic()) {
            assert!(!foreign.contains(&word.to_lowercase().as_str()), "{id}: {word}");
        }
    }
    assert!(locale(Language::German).concat().contains(['ä', 'ö', 'ü', 'ß']));
}

#[test]
fn every_parameter_has_a_name_and_a_description() {
    let known = texts(Language::English);
    for info in PARAMETERS {
        let id = format!("parameter-{}", info.name.replace('_', "-"));
        assert!(known.contains_key(&id), "{id}");
        assert!(known.contains_key(&format!("{id}.description")), "{id}.description");
        for language in Language::ALL {
            let text = Catalogue::new(language).parameter(info);
            assert!(!text.name.is_empty() && !text.description.is_empty(), "{id}");
        }
    }
    for id in known.keys().filter_map(|id| id.strip_prefix("parameter-")) {
        let name = id.split('.').next().unwrap_or(id).replace('-', "_");
        assert!(PARAMETERS.iter().any(|info| info.name == name), "no parameter {name}");
    }
}

/// Every Rust source of the workspace except this test, and those of the page.
fn sources() -> Vec<String> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of all crates");
    let page = crates.with_file_name("web").join("src");
    let mut folders: Vec<PathBuf> = vec![crates.to_owned(), page];
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry")) {
            let path = entry.path();
            if path.is_dir() {
                if path.file_name().is_none_or(|name| name != "target") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|end| end == "rs" || end == "ts")
                && !path.ends_with("federpendel-text/tests/catalogue.rs")
            {
                sources.push(fs::read_to_string(path).expect("a source"));
            }
        }
    }
    sources
}

/// The literals that `source` hands to `.text(…)`, `.format(…)` and `.say(…)`.
fn asked(source: &str) -> Vec<String> {
    [".text(", ".format(", ".say("]
        .iter()
        .flat_map(|call| source.split(call).skip(1))
        .filter_map(|rest| rest.trim_start().strip_prefix('"')?.split('"').next())
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_id_that_the_sources_ask_for_exists() {
    let known = texts(Language::English);
    for id in sources().iter().flat_map(|source| asked(source)) {
        assert!(known.contains_key(&id), "a source asks for “{id}”, which the catalogue lacks");
    }
}

#[test]
fn every_id_is_asked_for_somewhere() {
    let sources = sources();
    for id in texts(Language::English).keys() {
        // What the page says instead is asked for by the same name.
        let id = id.strip_suffix(".page").unwrap_or(id);
        // An id may be put together from a prefix and a name: format!("parameter-{name}").
        let prefix = id.split_once('-').map_or(id, |(prefix, _)| prefix);
        let literal = format!("\"{id}\"");
        let built = format!("\"{prefix}-{{");
        let used =
            sources.iter().any(|source| source.contains(&literal) || source.contains(&built));
        assert!(used, "no source asks for “{id}”");
    }
}
