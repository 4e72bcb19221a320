//! Writes a specimen of every block in both languages, ordinary and as a worksheet, to look at and to test
//! the layout: `cargo run -p federpendel-report --example specimen -- FOLDER`.

mod content;
mod figure;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use federpendel_report::html;
use federpendel_text::{Catalogue, Language};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("usage: specimen FOLDER")?;
    fs::create_dir_all(&folder)?;
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for (worksheet, kind) in [(false, "ordinary"), (true, "worksheet")] {
            let page = html::page(&content::document(&catalogue, worksheet)?, &catalogue)?;
            fs::write(Path::new(&folder).join(format!("{kind}-{}.html", language.tag())), page)?;
        }
    }
    Ok(())
}
