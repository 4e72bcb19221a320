//! Draws every kind of plot from real computations, to look at: `cargo run --example gallery -- FOLDER`.

mod methods;
mod motions;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use federpendel_text::plot::Plot;
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::{Catalogue, Language};

type Drawn = federpendel::Result<Vec<(String, Plot)>>;

fn write(folder: &Path, name: &str, plot: &Plot) -> Result<(), Box<dyn Error>> {
    let file = |end: &str| folder.join(format!("{name}-{}{end}", plot.language.tag()));
    for (background, end) in [(Background::Light, ""), (Background::Dark, "-dark")] {
        let size = Size::of(plot);
        fs::write(file(&format!("{end}.svg")), svg(plot, size, background))?;
        fs::write(file(&format!("{end}.png")), png(plot, size, background, 2.0)?)?;
    }
    let texts = [50, 80, 120, 200].map(|columns| terminal(plot, columns, 24, false));
    fs::write(file(".txt"), format!("{}\n{}", texts.concat(), plot.description))?;
    fs::write(file(".ansi"), terminal(plot, 80, 24, true))?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("usage: gallery FOLDER")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for (name, plot) in motions::plots(&catalogue)?.iter().chain(&methods::plots(&catalogue)?) {
            write(folder, name, plot)?;
        }
    }
    Ok(())
}
