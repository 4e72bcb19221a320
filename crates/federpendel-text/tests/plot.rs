//! Plots: what the description says, and that every back end draws it whole.

use std::f64::consts::PI;

use federpendel::{Kind, Mix, Outcome, Rest, TurningPoint};
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::plot::{Axis, MotionData, Plot, Role, Style};
use federpendel_text::{Catalogue, Language};

/// The record of an oscillation x = a cos(ωt) whose amplitude a falls evenly to zero.
struct Record {
    times: Vec<f64>,
    positions: Vec<f64>,
    turning_points: Vec<TurningPoint>,
    outcome: Outcome,
}

fn record(swings: u32, duration: f64, samples: u32) -> Record {
    let swing = duration / f64::from(swings + 1);
    let amplitude = |time: f64| 0.1 * (1.0 - time / (2.0 * duration));
    let at = |time: f64| amplitude(time) * (PI * time / swing).cos();
    let times: Vec<_> =
        (0..samples).map(|i| duration * f64::from(i) / f64::from(samples - 1)).collect();
    let turning_points: Vec<_> = (1..=swings)
        .map(|n| f64::from(n) * swing)
        .map(|time| TurningPoint { time, position: at(time) })
        .collect();
    let last = turning_points.last().copied().unwrap_or(TurningPoint { time: 0.0, position: 0.0 });
    let outcome = Outcome::Rests(Rest {
        time: last.time,
        position: last.position,
        swings: swings.into(),
        margin: 0.5,
        tie: false,
    });
    Record { positions: times.iter().map(|t| at(*t)).collect(), times, turning_points, outcome }
}

fn plot(language: Language, record: &Record) -> Plot {
    let data = MotionData {
        mix: Mix { stokes: false, coulomb: true, newton: false },
        times: &record.times,
        positions: &record.positions,
        turning_points: &record.turning_points,
        from_rest: true,
        outcome: &record.outcome,
        sticking_offset: 0.004905,
    };
    Plot::motion(&Catalogue::new(language), &data)
}

#[test]
fn a_motion_is_described_with_everything_that_is_in_it() {
    let plot = plot(Language::German, &record(10, 5.0, 500));
    assert_eq!(plot.title, "Federpendel, Coulombsche Reibung");
    assert_eq!((&*plot.x.label, &*plot.y.label), ("Zeit t in s", "Auslenkung x in cm"));
    let series: Vec<_> = plot
        .series
        .iter()
        .map(|series| (&*series.name, series.role, series.points.len()))
        .collect();
    let expected = [
        ("Auslenkung", Role::Exact, 510),
        ("Einhüllende", Role::Envelope, 11),
        ("", Role::Envelope, 11),
        ("Umkehrpunkte", Role::TurningPoints, 9),
        ("Ruhe: 4,545 s, 5,455 cm", Role::Rest, 1),
    ];
    assert_eq!(series, expected);
    assert_eq!(plot.series[0].points[0], (0.0, 10.0));
    assert_eq!(plot.bands[0].name, "Haftbereich ±4,905 mm");
    assert_eq!(
        plot.description,
        "Federpendel, Coulombsche Reibung: Auslenkung über 5 s, ab 10 cm beim Loslassen, zwischen \
         −9,546 cm und 10 cm. Die Masse kommt nach 10 Halbschwingungen zur Ruhe, bei 4,545 s, \
         5,455 cm von der Mitte."
    );
}

#[test]
fn a_curve_that_follows_the_motion_is_seen_on_it() {
    let record = record(4, 5.0, 500);
    let catalogue = Catalogue::new(Language::German);
    for (kind, name) in [
        (Kind::ClosedForm, "Exakte Bewegung"),
        (Kind::FirstIntegral, "Exakte Bewegung"),
        (Kind::Series, "Bewegung (auf Rundung genau)"),
    ] {
        let mut plot = plot(Language::German, &record);
        let curve = record.times.iter().copied().zip(record.positions.iter().copied());
        plot.compare(&catalogue, kind, "article-scheme", curve);
        assert_eq!((&*plot.series[0].name, &*plot.series[1].name), (name, "article-scheme"));
        assert!(
            plot.description.contains("article-scheme, zwischen −9,005 cm"),
            "{}",
            plot.description
        );
        // Without colour, and where every point lies on the motion: both signs are there.
        let text = terminal(&plot, 80, 24, false);
        let beads = text.matches('×').count();
        assert!((40..200).contains(&beads), "{text}");
        assert!(text.contains("× × article-scheme"), "{text}");
        for (background, below, above) in
            [(Background::Light, "#0072b2", "#00402b"), (Background::Dark, "#56b4e9", "#e9ff9c")]
        {
            let text = svg(&plot, Size::default(), background);
            let line = |colour: &str| {
                let is_it = |line: &&str| line.contains(colour) && line.matches(' ').count() > 100;
                let at = text.split('<').position(|line| is_it(&line)).expect("a curve");
                (at, text.split('<').nth(at).unwrap_or_default().to_owned())
            };
            let ((lower, solid), (upper, dashed)) = (line(below), line(above));
            assert!(lower < upper, "the comparison lies above the motion");
            assert!(!solid.contains("dasharray") && dashed.contains("dasharray"), "{dashed}");
        }
    }
}

#[test]
fn a_rest_after_the_record_is_not_drawn() {
    let mut record = record(10, 5.0, 500);
    record.times.truncate(100);
    record.positions.truncate(100);
    record.turning_points.truncate(2);
    let plot = plot(Language::English, &record);
    assert!(plot.series.iter().all(|series| series.role != Role::Rest));
}

#[test]
fn svg_is_well_formed_and_says_what_it_shows() {
    for (background, language) in
        [(Background::Light, Language::German), (Background::Dark, Language::English)]
    {
        let plot = plot(language, &record(10, 5.0, 500));
        let text = svg(&plot, Size::default(), background);
        let document = roxmltree::Document::parse(&text).expect("well-formed XML");
        let root = document.root_element();
        assert_eq!(root.attribute("role"), Some("img"));
        assert_eq!(root.attribute("viewBox"), Some("0 0 800 500"));
        let content = |tag: &str| {
            let mut nodes = document.descendants().filter(|node| node.has_tag_name(tag));
            nodes.next().and_then(|node| node.text()).map(str::to_owned)
        };
        assert_eq!(content("title").as_ref(), Some(&plot.title));
        assert_eq!(content("desc").as_ref(), Some(&plot.description));
        let texts: Vec<_> = document
            .descendants()
            .filter(|node| node.has_tag_name("text"))
            .filter_map(|node| node.text())
            .collect();
        let legend = plot.series.iter().map(|series| &series.name).filter(|name| !name.is_empty());
        for label in [&plot.title, &plot.x.label, &plot.y.label].into_iter().chain(legend) {
            assert!(texts.contains(&label.as_str()), "{label} in {texts:?}");
        }
        assert!(texts.contains(&"−5"), "{texts:?}");
    }
}

#[test]
fn svg_escapes_what_xml_would_misread() {
    let mut plot = plot(Language::English, &record(10, 5.0, 500));
    plot.title = "a < b & \"c\"".to_owned();
    let text = svg(&plot, Size::default(), Background::Light);
    assert!(roxmltree::Document::parse(&text).is_ok());
}

#[test]
fn png_has_its_size_and_is_not_blank() {
    let plot = plot(Language::German, &record(10, 5.0, 500));
    let bytes = png(&plot, Size::default(), Background::Light, 2.0).expect("a picture");
    let mut reader =
        png_decoder::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("an image");
    assert_eq!((info.width, info.height), (1600, 1000));
    let samples = info.color_type.samples();
    let colours: std::collections::BTreeSet<_> = pixels.chunks(samples).collect();
    assert!(colours.len() > 100, "{} colours", colours.len());
}

#[test]
fn terminal_plots_have_the_width_asked_for_and_no_escapes_without_colour() {
    let plot = plot(Language::German, &record(10, 5.0, 500));
    for columns in [40, 60, 80, 100, 120, 200] {
        let text = terminal(&plot, columns, 24, false);
        let widths: Vec<_> = text.lines().map(|line| line.chars().count()).collect();
        assert_eq!(widths.iter().max(), Some(&columns), "{text}");
        assert!(!text.contains('\x1b'));
        for label in [&plot.title, &plot.x.label, &plot.y.label, &plot.bands[0].name] {
            assert!(text.contains(label.as_str()), "{label}");
        }
        let coloured = terminal(&plot, columns, 24, true);
        assert!(coloured.contains('\x1b'));
        let mut plain = String::new();
        for (i, part) in coloured.split("\x1b[").enumerate() {
            plain += if i == 0 { part } else { part.split_once('m').expect("an escape").1 };
        }
        assert_eq!(plain, text);
    }
}

#[test]
fn many_swings_fill_their_range_without_a_false_beat() {
    // Fewer samples than swings: drawn as they are, they would show an oscillation that is not there.
    let plot = plot(Language::English, &record(100_000, 5.0, 2001));
    let text = terminal(&plot, 80, 24, false);
    let middle =
        text.lines().find(|line| line.trim_start().starts_with("0 ┤")).expect("the line of x = 0");
    let cells: Vec<_> = middle.split('┤').nth(1).expect("the canvas").chars().collect();
    // The marker of the rest stands on the edge, which leaves some room at both ends.
    let inner = &cells[3..cells.len() - 3];
    assert!(inner.len() > 60 && inner.iter().all(|cell| *cell == '⣿'), "{text}");
    let picture = svg(&plot, Size::default(), Background::Light);
    assert!(picture.len() < 300_000, "{} bytes", picture.len());
}

#[test]
fn empty_and_still_motions_can_be_drawn() {
    for (times, positions) in [
        (vec![], vec![]),
        (vec![0.0], vec![0.0]),
        (vec![0.0, 1.0], vec![0.0, 0.0]),
        (vec![0.0, 1e300], vec![1e300, -1e300]),
        (vec![0.0, 1e-300], vec![1e-300, 0.0]),
    ] {
        let record =
            Record { times, positions, turning_points: Vec::new(), outcome: Outcome::Swings };
        let plot = plot(Language::English, &record);
        assert!(terminal(&plot, 60, 20, true).contains("Time"));
        let text = svg(&plot, Size::default(), Background::Dark);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        assert!(png(&plot, Size::default(), Background::Dark, 1.0).is_ok());
    }
}

#[test]
fn logarithmic_axes_and_stacked_areas() {
    let catalogue = Catalogue::new(Language::German);
    let x = Axis::new(&catalogue, "Zeitschritt", "Δt", "s", 1e-3).logarithmic();
    let y = Axis::new(&catalogue, "Fehler", "ε", "1", 1.0).logarithmic();
    let mut plot = Plot::new(&catalogue, "Fehler".to_owned(), x, y);
    let points = (0..8).map(|i| 10f64.powi(-i)).map(|step| (step, step * step));
    plot.add("zweite Ordnung", Role::Comparison(0), Style::SOLID, points);
    assert!(terminal(&plot, 80, 24, false).contains("10⁻⁶"));
    assert!(svg(&plot, Size::default(), Background::Light).contains("10⁻⁶"));

    let (x, y) = (
        Axis::new(&catalogue, "Zeit", "t", "s", 1.0),
        Axis::new(&catalogue, "Energie", "E", "J", 1.0),
    );
    let mut plot = Plot::new(&catalogue, "Energie".to_owned(), x, y);
    plot.add("Wärme", Role::Comparison(0), Style::SOLID, [(0.0, 1.0), (1.0, 1.0)]);
    plot.series[0].lower = Some(vec![0.0, 0.5]);
    assert!(terminal(&plot, 80, 24, false).contains("Wärme"));
    assert!(svg(&plot, Size::default(), Background::Light).contains("Wärme"));
}
