//! The sentences that the page's TypeScript asks for.

use std::fs;
use std::path::{Path, PathBuf};

use federpendel_wasm::words::{self, catalogue};

fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path: PathBuf = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "ts") {
            found.push(fs::read_to_string(path).unwrap());
        }
    }
}

#[test]
fn the_page_has_every_sentence_that_it_asks_for() {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/src"), &mut files);
    let asked = |file: &String| -> Vec<String> {
        let after = file.split("say(").skip(1);
        let literal =
            after.filter_map(|rest| rest.strip_prefix(['"', '\''])?.split(['"', '\'']).next());
        literal.map(str::to_owned).collect()
    };
    let ids: Vec<_> = files.iter().flat_map(asked).collect();
    assert!(ids.len() > 50, "{}", ids.len());
    for id in ids {
        assert!(catalogue("en").contains(&id), "the page asks for “{id}”, which it does not have");
    }
}

#[test]
fn sentences_take_texts_and_numbers() {
    let said = words::text(catalogue("de"), "count-swings", r#"{ "swings": 1 }"#);
    assert_eq!(said.as_deref(), Ok("1 Halbschwingung"));
    let said = words::text(catalogue("de"), "quoted", r#"{ "text": "a" }"#);
    assert_eq!(said.as_deref(), Ok("„a“"));
    assert!(words::text(catalogue("de"), "no-such", "{}").is_err());
    assert!(words::text(catalogue("de"), "quoted", "[").is_err());
}
