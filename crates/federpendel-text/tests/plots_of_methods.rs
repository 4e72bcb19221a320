//! Plots of methods beside the exact motion: errors, convergence, work, overlay.

use federpendel::lens::Rung;
use federpendel::{Kind, Mix, Outcome, Rest, TurningPoint};
use federpendel_text::plot::draw::{Background, Size, svg, terminal};
use federpendel_text::plot::{
    ConvergenceData, ErrorsData, MethodCurve, MethodErrors, MethodRungs, OverlayData, Plot, Role,
    Scale, Style,
};
use federpendel_text::{Catalogue, Language};

const COULOMB: Mix = Mix { stokes: false, coulomb: true, newton: false };

/// Every back end draws `plot`, with the words that stand in it.
fn assert_drawn(plot: &Plot) {
    assert!(!plot.title.is_empty() && plot.description.contains(&plot.title), "{plot:?}");
    for background in [Background::Light, Background::Dark] {
        let text = svg(plot, Size::of(plot), background);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        assert!(roxmltree::Document::parse(&text).is_ok());
    }
    for columns in [50, 80, 120] {
        let text = terminal(plot, columns, 24, false);
        for line in text.lines() {
            assert!(line.chars().count() <= columns, "{line}");
        }
        assert!(text.contains(&plot.x.label) && text.contains(&plot.y.label));
    }
}

fn names(plot: &Plot) -> Vec<&str> {
    plot.series.iter().map(|series| series.name.as_str()).filter(|name| !name.is_empty()).collect()
}

fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).expect("well-formed XML");
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts.filter_map(|node| node.text()).map(str::to_owned).collect()
}

#[test]
fn errors_stand_on_a_logarithmic_axis_without_those_that_vanish() {
    let times = [0.0, 1.0, 2.0, 3.0];
    let (first, second) = ([0.0, -1e-4, 1e-25, 2e-4], [0.0, 1e-12, 1e-9, f64::NAN]);
    let methods = [
        MethodErrors { name: "rk4", number: 0, times: &times, errors: &first },
        MethodErrors { name: "verlet", number: 1, times: &times, errors: &second },
    ];
    for language in Language::ALL {
        let data = ErrorsData { mix: COULOMB, amplitude: 0.1, methods: &methods };
        let plot = Plot::errors(&Catalogue::new(language), &data);
        assert_drawn(&plot);
        assert_eq!(names(&plot), ["rk4", "verlet"]);
        assert_eq!(plot.y.scale, Scale::Logarithmic);
        assert_eq!(plot.series[0].points, [(1.0, 1e-4), (3.0, 2e-4)]);
        assert_eq!(plot.series[1].points, [(1.0, 1e-12), (2.0, 1e-9)]);
        assert!(texts(&svg(&plot, Size::default(), Background::Light)).contains(&"10⁻¹²".into()));
    }
    let german = Catalogue::new(Language::German);
    let data = ErrorsData { mix: COULOMB, amplitude: 0.1, methods: &methods[..1] };
    let description = Plot::errors(&german, &data).description;
    assert!(
        description.ends_with("über 3 s, auf logarithmischer Achse. Größter Fehler: rk4 200 µm.")
    );
}

#[test]
fn no_errors_are_said_to_be_none() {
    let german = Catalogue::new(Language::German);
    let methods =
        [MethodErrors { name: "rk4", number: 0, times: &[0.0, 1.0], errors: &[0.0, 0.0] }];
    let data = ErrorsData { mix: COULOMB, amplitude: 0.1, methods: &methods };
    let empty = ConvergenceData { mix: COULOMB, methods: &[] };
    for plot in [
        Plot::errors(&german, &data),
        Plot::convergence(&german, &empty),
        Plot::work(&german, &empty),
    ] {
        assert_drawn(&plot);
        assert_eq!(plot.notes[0].text, "Kein Fehler über null zu zeigen");
        assert!(terminal(&plot, 80, 24, false).contains(&plot.notes[0].text));
    }
}

/// Rungs of a method of this order.
fn rungs(order: i32) -> Vec<Rung> {
    let rung = |k: i32| {
        let step = 0.01 * 0.5f64.powi(k);
        Rung { time_step: step, tolerance: None, error: step.powi(order), steps: 100 << k }
    };
    (0..7).map(rung).collect()
}

#[test]
fn convergence_shows_observed_orders_and_triangles_of_the_declared_ones() {
    let (first, fourth) = (rungs(1), rungs(4));
    let methods = [
        MethodRungs { name: "symplectic-euler", number: 0, order: 1, rungs: &first },
        // Declared as of order two, as a method that suffers from dry friction may be.
        MethodRungs { name: "verlet", number: 1, order: 2, rungs: &first },
        MethodRungs { name: "rk4", number: 2, order: 4, rungs: &fourth },
    ];
    let data = ConvergenceData { mix: COULOMB, methods: &methods };
    for language in Language::ALL {
        let plot = Plot::convergence(&Catalogue::new(language), &data);
        assert_drawn(&plot);
        let sign = language.decimal_sign();
        let expected = [("symplectic-euler", 1), ("verlet", 1), ("rk4", 4)];
        let expected = expected.map(|(name, order)| format!("{name} (p ≈ {order}{sign}0)"));
        assert_eq!(names(&plot), expected);
        let notes: Vec<_> = plot.notes.iter().map(|note| note.text.as_str()).collect();
        assert_eq!(notes[..3], ["1", "2", "4"]);
        // Every side rises with its order, and all lie below the curves above them.
        let guides = plot.series.iter().filter(|series| series.role == Role::Guide);
        for (side, order) in guides.skip(1).zip([1.0, 2.0, 4.0]) {
            let ((x, y), (right, top)) = (side.points[0], side.points[1]);
            assert!(((top / y).ln() / (right / x).ln() - order).abs() < 1e-9);
            assert!(top < (x * 1e-3).powi(4), "{top}");
        }
        let work = Plot::work(&Catalogue::new(language), &data);
        assert_drawn(&work);
        assert_eq!(work.series[2].points[6].0, 6400.0);
        assert!(work.description.contains("rk4: 6"), "{}", work.description);
    }
    let german = Plot::convergence(&Catalogue::new(Language::German), &data);
    assert!(german.description.contains("verlet: Ordnung 2 laut Entwurf, 1,0 beobachtet"));
}

#[test]
fn twelve_methods_are_told_apart_and_listed_whole() {
    let rungs = rungs(2);
    let long: Vec<_> = (0..12).map(|n| format!("method-with-a-name-{n}")).collect();
    let methods: Vec<_> = long
        .iter()
        .enumerate()
        .map(|(number, name)| MethodRungs { name, number, order: 2, rungs: &rungs })
        .collect();
    let data = ConvergenceData { mix: COULOMB, methods: &methods };
    let plot = Plot::work(&Catalogue::new(Language::German), &data);
    let styles: Vec<Style> = plot.series.iter().map(|series| series.style).collect();
    for background in [Background::Light, Background::Dark] {
        let text = svg(&plot, Size::default(), background);
        let document = roxmltree::Document::parse(&text).expect("well-formed XML");
        let strokes: std::collections::BTreeSet<_> = document
            .descendants()
            .filter(|node| node.attribute("d").is_some_and(|path| path.matches(' ').count() > 10))
            .filter_map(|node| {
                Some((node.attribute("stroke")?, node.attribute("stroke-dasharray")))
            })
            .collect();
        let colours: std::collections::BTreeSet<_> = strokes.iter().map(|line| line.0).collect();
        assert!(colours.len() >= 12, "{colours:?}");
        let place = |node: roxmltree::Node<'_, '_>, name| -> f64 {
            node.attribute(name).and_then(|value| value.parse().ok()).unwrap_or(f64::NAN)
        };
        let mut entries: Vec<_> = document
            .descendants()
            .filter(|node| node.text().is_some_and(|text| long.iter().any(|name| name == text)))
            .filter(|node| node.has_tag_name("text"))
            .map(|node| (place(node, "y"), place(node, "x")))
            .collect();
        assert_eq!(entries.len(), 12);
        entries.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        for pair in entries.windows(2) {
            let apart = pair[1].0 - pair[0].0 >= 12.0 || pair[1].1 - pair[0].1 >= 150.0;
            assert!(apart, "{pair:?}");
        }
        assert!(entries.iter().all(|(y, x)| *y <= 500.0 && *x + 140.0 <= 800.0), "{entries:?}");
    }
    for (n, style) in styles.iter().enumerate() {
        assert!(!styles[..n].contains(style), "{style:?}");
    }
}

type Overlaid = fn(&Catalogue, &OverlayData<'_>) -> Plot;

/// x = cos t with a method that is late, and one that runs away, in one of the plots that show such.
fn overlaid(plot: Overlaid, language: Language, outcome: &Outcome) -> Plot {
    let times: Vec<f64> = (0..=400).map(|i| f64::from(i) * 0.05).collect();
    let exact: Vec<f64> = times.iter().map(|t| 0.1 * t.cos()).collect();
    let late: Vec<f64> = times.iter().map(|t| 0.1 * (t - 0.2).cos()).collect();
    let wild: Vec<f64> = times.iter().map(|t| 0.1 * (t * t).exp()).collect();
    let pi = std::f64::consts::PI;
    let turn = |n: i32| TurningPoint { time: f64::from(n) * pi, position: 0.1 * (-1f64).powi(n) };
    let turning_points: Vec<_> = (1..=6).map(turn).collect();
    let curve = |name, positions| MethodCurve { name, number: 0, times: &times, positions };
    let data = OverlayData {
        mix: COULOMB,
        kind: Kind::ClosedForm,
        times: &times,
        positions: &exact,
        turning_points: &turning_points,
        outcome,
        sticking_offset: 0.005,
        methods: &[curve("late", &late), curve("wild", &wild)],
    };
    plot(&Catalogue::new(language), &data)
}

#[test]
fn the_lens_looks_at_the_last_swings() {
    let pi = std::f64::consts::PI;
    let rest = Rest { time: 6.0 * pi, position: 0.1, swings: 6, margin: 0.5, tie: false };
    for language in Language::ALL {
        for (outcome, from) in [(Outcome::Rests(rest), 4.0 * pi), (Outcome::Swings, 3.0 * pi)] {
            let plot = overlaid(Plot::overlay, language, &outcome);
            assert_drawn(&plot);
            assert_eq!(names(&plot)[1..], ["late", "wild"]);
            let lens = plot.lens.as_deref().expect("a lens");
            let (low, high) = lens.x.limits.expect("limits");
            assert!((low - from).abs() < 1e-9 && high <= 20.0 && high > 6.0 * pi, "{low} {high}");
            // What runs away does not flatten the rest.
            assert!(plot.y.limits.expect("limits").1 < 20.0);
            assert!(terminal(&plot, 80, 24, false).contains(&lens.title));
            assert!(texts(&svg(&plot, Size::of(&plot), Background::Dark)).contains(&lens.title));
        }
    }
}

fn rest(time: f64) -> Outcome {
    Outcome::Rests(Rest { time, position: 0.1, swings: 6, margin: 0.5, tie: false })
}

#[test]
fn methods_beside_the_motion_keep_its_height_without_a_lens() {
    for language in Language::ALL {
        let beside = overlaid(Plot::beside, language, &Outcome::Swings);
        assert_drawn(&beside);
        assert!(beside.lens.is_none());
        // The same curves within the same limits as in the overlay.
        let overlay = overlaid(Plot::overlay, language, &Outcome::Swings);
        assert_eq!((&beside.series, &beside.y), (&overlay.series, &overlay.y));
        let (low, high) = beside.y.limits.expect("limits");
        assert!((-20.0..=-10.0).contains(&low) && (10.0..=20.0).contains(&high), "{low} {high}");
        let end = if language == Language::German { "late 5,813 cm" } else { "late 5.813 cm" };
        assert!(beside.description.contains(end), "{}", beside.description);
    }
}

#[test]
fn after_the_rest_the_sticking_band_fills_the_plot() {
    let pi = std::f64::consts::PI;
    for language in Language::ALL {
        let plot = overlaid(Plot::after_rest, language, &rest(4.5 * pi));
        assert_drawn(&plot);
        // From the last turning point before the rest, on the scale of ±5 mm.
        let (from, until) = plot.x.limits.expect("limits");
        assert!((from - 4.0 * pi).abs() < 1e-9 && (until - 20.0).abs() < 1e-9, "{from} {until}");
        assert_eq!(plot.y.limits, Some((-6.5, 6.5)));
        assert_eq!((plot.bands[0].low, plot.bands[0].high), (-5.0, 5.0));
        assert_eq!(names(&plot)[1..], ["late", "wild"]);
    }
}

#[test]
fn a_record_without_a_rest_says_so() {
    for outcome in [Outcome::Swings, rest(21.0)] {
        let plot = overlaid(Plot::after_rest, Language::German, &outcome);
        assert_drawn(&plot);
        assert_eq!(plot.notes[0].text, "In dieser Zeit kommt die Masse nicht zur Ruhe");
        assert!(plot.description.contains(&plot.notes[0].text));
        let (low, high) = plot.y.limits.expect("limits");
        assert!(low < -10.0 && high > 10.0);
    }
}
