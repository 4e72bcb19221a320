//! Plots that stand within a page: their colours, ids and sizes; the roots of the characteristic equation.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use federpendel_text::plot::draw::{Background, Size, inline, palette, svg, terminal};
use federpendel_text::plot::{Axis, Course, CoursesData, Plot, Role, RootsData, Style};
use federpendel_text::{Catalogue, Language};

/// A plot of an oscillation of so many swings, known at so many times.
fn oscillation(swings: f64, samples: u32) -> Plot {
    let times: Vec<f64> = (0..samples).map(|i| f64::from(i) / f64::from(samples - 1)).collect();
    let positions: Vec<f64> =
        times.iter().map(|t| (1.0 - t / 2.0) * (PI * swings * t).cos()).collect();
    let curve = Course { name: "x", role: Role::Exact, times: &times, positions: &positions };
    let data = CoursesData { title: "a < b", curves: &[curve] };
    Plot::courses(&Catalogue::new(Language::English), &data)
}

/// A plot with everything that can be drawn: lines, markers, areas, bands, notes, a lens.
fn everything() -> Plot {
    let catalogue = Catalogue::new(Language::German);
    let axis = |symbol| Axis::new(&catalogue, "Länge", symbol, "m", 1.0);
    let mut plot = Plot::new(&catalogue, "Alles".to_owned(), axis("x"), axis("y"));
    let roles = [
        Role::Exact,
        Role::Envelope,
        Role::TurningPoints,
        Role::Swings,
        Role::Release,
        Role::Rest,
        Role::Experiment,
        Role::Sticking,
        Role::Kinetic,
        Role::Potential,
        Role::Stokes,
        Role::Coulomb,
        Role::Newton,
        Role::Guide,
    ];
    for (n, role) in roles.into_iter().chain((0..12).map(Role::Comparison)).enumerate() {
        let points = (0..9).map(|i| (f64::from(i), f64::from(i % 3) + n as f64));
        plot.add(format!("{role:?}"), role, Style::comparison(n), points);
    }
    plot.series[8].lower = Some(vec![0.0; 9]);
    plot.add_band("Band", 1.0, 2.0);
    plot.add_note("Notiz", (4.0, 4.0));
    plot.description = "Alles: mit & ohne.".to_owned();
    plot.lens = Some(Box::new(plot.clone()));
    plot
}

#[test]
fn a_drawing_on_a_page_takes_its_colours_from_the_page() {
    let plot = everything();
    let text = inline(&plot, Size::figure(&plot), "figure-1");
    let used: BTreeSet<&str> =
        text.split("var(").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert_eq!(used.len(), 14 + 12 + 4, "{used:?}");
    for background in [Background::Light, Background::Dark] {
        let declarations = palette(background);
        let declared: BTreeSet<&str> =
            declarations.split(';').filter_map(|line| Some(line.split_once(':')?.0)).collect();
        assert_eq!(used, declared);
    }
    assert_ne!(palette(Background::Light), palette(Background::Dark));
    // No colour of its own, and none that a background would hide.
    for attribute in ["fill=\"#", "stroke=\"#", "white", "black"] {
        assert!(!text.contains(attribute), "{attribute} in {text}");
    }
}

#[test]
fn drawings_on_a_page_are_told_apart_and_say_what_they_show() {
    let plot = everything();
    let drawings = ["figure-1", "figure-2"].map(|id| inline(&plot, Size::figure(&plot), id));
    assert_eq!(drawings[0], inline(&plot, Size::figure(&plot), "figure-1"), "drawn anew");
    let page = format!("<body>{}{}</body>", drawings[0], drawings[1]);
    let document = roxmltree::Document::parse(&page).expect("well-formed XML");
    let ids: Vec<_> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len(), "{ids:?}");
    for reference in page.split("url(#").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(ids.contains(&reference), "{reference} in {ids:?}");
    }
    for drawing in document.root_element().children().filter(|node| node.is_element()) {
        assert_eq!(drawing.attribute("role"), Some("img"));
        assert_eq!(drawing.attribute("lang"), Some("de"));
        assert_eq!((drawing.attribute("width"), drawing.attribute("height")), (None, None));
        let Size { width, height } = Size::figure(&plot);
        assert_eq!(drawing.attribute("viewBox"), Some(&*format!("0 0 {width} {height}")));
        let labels = drawing.attribute("aria-labelledby").expect("labels");
        let said: Vec<_> = labels
            .split(' ')
            .map(|id| drawing.descendants().find(|node| node.attribute("id") == Some(id)))
            .map(|node| node.and_then(|node| node.text()))
            .collect();
        assert_eq!(said, [Some("Alles"), Some("Alles: mit & ohne.")]);
        // The caption has the title of the whole; that of the lens stands above it.
        let titles = drawing.descendants().filter(|node| node.has_tag_name("text"));
        assert_eq!(titles.filter(|node| node.text() == Some("Alles")).count(), 1);
    }
}

#[test]
fn long_records_stay_small() {
    for swings in [3.0, 30.0, 3000.0] {
        let plot = oscillation(swings, 10_000);
        let text = inline(&plot, Size::figure(&plot), "x");
        assert!(text.len() < 30_000, "{swings}: {} bytes", text.len());
        assert!(roxmltree::Document::parse(&text).is_ok());
    }
}

fn roots(language: Language, ratio: f64) -> Plot {
    Plot::roots(&Catalogue::new(language), &RootsData { omega0: 6.0, gamma: 6.0 * ratio })
}

#[test]
fn roots_have_the_sum_and_product_of_vieta() {
    for ratio in [0.0, 0.3, 1.0, 1.7, 12.0] {
        let plot = roots(Language::German, ratio);
        let of = |role| {
            let series = plot.series.iter().filter(move |series| series.role == role);
            series.flat_map(|series| series.points.clone()).collect::<Vec<_>>()
        };
        let own = of(Role::Experiment);
        let (first, second) = (own[0], own[1]);
        assert!((first.0 + second.0 + 12.0 * ratio).abs() < 1e-9, "{own:?}");
        // Of a conjugate pair as of a real one.
        let product = first.0 * second.0 - first.1 * second.1;
        assert!((product - 36.0).abs() < 1e-9 && (first.1 + second.1).abs() < 1e-12, "{own:?}");
        let (upper, lower) = (of(Role::Exact), of(Role::Envelope));
        for (a, b) in upper.iter().zip(&lower) {
            assert!((a.0 * b.0 - a.1 * b.1 - 36.0).abs() < 1e-9, "{a:?} {b:?}");
        }
        // The paths reach as far as the own pair.
        assert!(lower.iter().any(|point| point.0 <= second.0 + 1e-9), "{own:?}");
        assert!(plot.description.contains("ω₀ = 6 1/s"), "{}", plot.description);
    }
    let plot = roots(Language::German, 1.25);
    assert!(plot.description.ends_with("Dieser Versuch, γ = 7,5 1/s: λ₁ = −3 1/s, λ₂ = −12 1/s."));
    let plot = roots(Language::English, 0.6);
    assert!(plot.description.ends_with("γ = 3.6 1/s: λ = (−3.6 ± 4.8 i) 1/s."));
}

#[test]
fn the_circle_of_the_roots_looks_like_one() {
    for (ratio, size) in [
        (0.1, Size::default()),
        (0.1, Size { width: 500.0, height: 900.0 }),
        (9.0, Size::default()),
    ] {
        let text = svg(&roots(Language::English, ratio), size, Background::Light);
        // From iω0 to −ω0, the whole first quarter.
        let path = text.split("<path d=\"").find(|path| path.contains("#0072b2")).expect("a path");
        let numbers: Vec<f64> = path
            .split('"')
            .next()
            .unwrap_or_default()
            .split([' ', 'M', 'L'])
            .filter_map(|number| number.parse().ok())
            .collect();
        let (across, down) = (numbers[0] - numbers[120], numbers[121] - numbers[1]);
        assert!(across > 5.0 && (across - down).abs() < 0.02 * across, "{across} {down}");
    }
}

#[test]
fn marks_of_the_roots_are_read_in_a_terminal() {
    for language in Language::ALL {
        for columns in [50, 80, 120] {
            let text = terminal(&roots(language, 0.03), columns, 24, false);
            assert!(text.lines().all(|line| line.chars().count() <= columns), "{text}");
            for mark in ["γ = 0", "γ = ω₀", "γ = 2 ω₀"] {
                assert!(text.contains(mark), "{mark} in {text}");
            }
            assert!(text.contains('◆') && text.matches('●').count() > 4, "{text}");
        }
    }
}

#[test]
fn roots_of_nothing_are_drawn_without_a_path() {
    for (omega0, gamma) in [(0.0, 1.0), (1.0, f64::NAN), (f64::INFINITY, 1.0), (1.0, -1.0)] {
        let plot = Plot::roots(&Catalogue::new(Language::English), &RootsData { omega0, gamma });
        assert!(plot.series.is_empty() && plot.description == plot.title, "{plot:?}");
        let text = inline(&plot, Size::figure(&plot), "x");
        assert!(roxmltree::Document::parse(&text).is_ok() && !text.contains("NaN"), "{text}");
        assert!(!terminal(&plot, 80, 24, false).is_empty());
    }
}
