//! Draws every kind of plot from real computations, to look at: `cargo run --example gallery -- FOLDER`, or
//! only some of them: `… -- FOLDER figures` (or `motions`, or `methods`).

mod figures;
mod methods;
mod motions;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use federpendel_text::plot::Plot;
use federpendel_text::plot::draw::{Background, Size, inline, palette, png, svg, terminal};
use federpendel_text::{Catalogue, Language};

type Part = fn(&Catalogue) -> Drawn;
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

/// A page with every plot in it, light or dark as the reader's screen is.
fn page(language: Language, plots: &[(String, Plot)]) -> String {
    let figure = |(name, plot): &(String, Plot)| {
        let drawing = inline(plot, Size::figure(plot), name);
        format!("<figure>{drawing}<figcaption>{}</figcaption></figure>\n", plot.description)
    };
    let figures: String = plots.iter().map(figure).collect();
    let [light, dark] = [Background::Light, Background::Dark].map(palette);
    format!(
        "<!doctype html><html lang=\"{}\"><meta charset=\"utf-8\"><title>federpendel</title>\
         <meta name=\"viewport\" content=\"width=device-width\"><style>\
         :root{{color-scheme:light dark;{light}}}\
         @media screen and (prefers-color-scheme:dark){{:root{{background:#1e1e1e;{dark}}}}}\
         body{{max-width:50rem;margin:1rem auto;line-height:1.4;padding:0 1rem;font-family:sans-serif}}\
         figure{{margin:2rem 0}}svg{{display:block;width:100%;margin:auto}}</style>\n{figures}</html>\n",
        language.tag(),
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let folder = arguments.next().ok_or("usage: gallery FOLDER [motions|methods|figures]")?;
    let folder = Path::new(&folder);
    let part = arguments.next();
    let parts: [(&str, Part); 3] =
        [("motions", motions::plots), ("methods", methods::plots), ("figures", figures::plots)];
    fs::create_dir_all(folder)?;
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for (name, plots) in parts {
            if part.as_ref().is_some_and(|part| part != name) {
                continue;
            }
            let plots = plots(&catalogue)?;
            for (name, plot) in &plots {
                write(folder, name, plot)?;
            }
            let file = format!("{name}-{}.html", language.tag());
            fs::write(folder.join(file), page(language, &plots))?;
        }
    }
    Ok(())
}
