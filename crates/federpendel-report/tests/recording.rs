//! The report of a fit: recordings of known truth, read, fitted and written down.

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes, even_times,
};
use federpendel_fit::read::{Choice, recordings};
use federpendel_fit::{Options, fit, ranking::LEVEL};
use federpendel_report::recording::{Fitted, document, sentences};
use federpendel_report::{Block, Document, Section, html};
use federpendel_text::{Catalogue, Language};

const WEIGHT: NormalForce = NormalForce::Weight(9.81);

/// Even numbers between −√3 and √3: variance 1 (SplitMix64).
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) as f64 / 2f64.powi(64) - 0.5) * 12f64.sqrt()
    }
}

/// A file as a measuring program writes it.
fn file(header: &str, times: &[f64], values: impl Iterator<Item = f64>, sigma: f64) -> String {
    let mut noise = noise(7);
    let rows = times.iter().zip(values);
    let rows = rows.map(|(time, value)| format!("{time:.4},{:.9}\n", value + sigma * noise()));
    format!("{header}\n{}", rows.collect::<String>())
}

fn fitted(name: &str, file: &str) -> Fitted {
    let mut reads = recordings(file.as_bytes(), &Choice::default()).expect("a recording");
    let read = reads.remove(0);
    let report = fit(&read.recording, &Options::default()).expect("a fit");
    Fitted::new(name.to_owned(), read, report)
}

fn motion(friction: impl Into<Friction>) -> Motion {
    let oscillator = Oscillator::new(0.5, 20.0, friction.into()).expect("an oscillator");
    Motion::new(oscillator, State::new(0.1, 0.0).expect("a state")).expect("a motion")
}

/// Stokes and Coulomb friction, which bring the mass to rest.
fn mixed() -> Motion {
    motion(Friction {
        stokes: Some(Stokes::new(0.1).expect("a law")),
        coulomb: Some(Coulomb::new(0.005, 0.005, WEIGHT).expect("a law")),
        newton: None,
    })
}

fn positions(motion: &Motion, header: &str, sigma: f64) -> String {
    let times = even_times(12.0, 1201).expect("times");
    let samples = motion.samples(&times).expect("samples");
    file(header, &times, samples.iter().map(|sample| sample.position), sigma)
}

fn velocities(motion: &Motion, sigma: f64) -> String {
    let times = even_times(12.0, 1201).expect("times");
    let samples = motion.samples(&times).expect("samples");
    file("t (s),v (m/s)", &times, samples.iter().map(|sample| sample.velocity), sigma)
}

/// A pendulum of 1 m from 80°, θ″ = −9.81 sin θ − 0.1 θ′, by the classical Runge–Kutta method.
fn pendulum() -> String {
    let times = even_times(20.0, 2001).expect("times");
    let rate = |[angle, speed]: [f64; 2]| [speed, -9.81 * angle.sin() - 0.1 * speed];
    let mut state = [80f64.to_radians(), 0.0];
    let mut angles = vec![state[0]];
    for _ in 1..times.len() {
        let along = |d: [f64; 2], h: f64| [state[0] + h * d[0], state[1] + h * d[1]];
        let a = rate(state);
        let b = rate(along(a, 0.005));
        let c = rate(along(b, 0.005));
        let d = rate(along(c, 0.01));
        let step = [0, 1].map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
        state = along(step, 0.01);
        angles.push(state[0]);
    }
    file("t (s),angle (rad)", &times, angles.into_iter(), 0.002)
}

fn english(fits: &[Fitted]) -> Document {
    document(fits, &[], &Catalogue::new(Language::English))
}

/// The document as lines. How often the model was computed may differ from one processor to the next.
fn lines(document: &Document) -> String {
    let lead: String = document.lead.iter().map(block_lines).collect();
    let text = format!("{}\n{lead}{}", document.title, section_lines(&document.sections, 1));
    let counted = ["evaluations of the model", "Berechnungen des Modells"];
    let same = |line: &&str| !counted.iter().any(|name| line.contains(name));
    text.lines().filter(same).map(|line| format!("{line}\n")).collect()
}

fn section_lines(sections: &[Section], depth: usize) -> String {
    let lines = |section: &Section| {
        let blocks: String = section.blocks.iter().map(block_lines).collect();
        let below = section_lines(&section.sections, depth + 1);
        format!("{} [{}] {}\n{blocks}{below}", "#".repeat(depth), section.id, section.heading)
    };
    sections.iter().map(lines).collect()
}

fn block_lines(block: &Block) -> String {
    match block {
        Block::Paragraph(text) => format!("{text}\n"),
        Block::Notice(text) => format!("! {text}\n"),
        Block::List(points) => points.iter().map(|point| format!("- {point}\n")).collect(),
        Block::Formula { tex, .. } => format!("$ {tex}\n"),
        Block::Figure { id, plots, caption } => {
            let plots = plots.iter().map(|plot| {
                let names: Vec<_> = plot.series.iter().map(|series| series.name.as_str()).collect();
                format!("    {} / {}: {}\n", plot.x.label, plot.y.label, names.join(" | "))
            });
            format!("[{id}] {caption}\n{}", plots.collect::<String>())
        }
        Block::Table { caption, head, rows } => {
            let rows = rows.iter().map(|row| {
                let mark = if row.marked { "*" } else { " " };
                let below = Some(&row.below).filter(|below| !below.is_empty());
                let below = below.map(|below| format!("      {below}\n")).unwrap_or_default();
                format!("  {mark} {}\n{below}", row.cells.join(" | "))
            });
            format!("{caption}\n    {}\n{}", head.join(" | "), rows.collect::<String>())
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_mix_with_a_rest() {
    let fit = fitted("data/mixed.csv", &positions(&mixed(), "t (s),x (m)", 5e-4));
    insta::assert_snapshot!(lines(&english(&[fit])));
}

#[test]
fn a_pendulum_that_no_mix_describes() {
    let fit = fitted("pendulum.csv", &pendulum());
    assert!(!fit.report.adequacy.adequate);
    insta::assert_snapshot!(lines(&english(&[fit])));
}

#[test]
fn a_recording_without_units() {
    let fit = fitted("plain.csv", &positions(&mixed(), "t,x", 5e-4));
    insta::assert_snapshot!(lines(&english(&[fit])));
}

#[test]
fn a_velocity_in_german() {
    let drag = motion(Newton::new(0.5).expect("a law"));
    let fit = fitted("geschwindigkeit.csv", &velocities(&drag, 2e-3));
    insta::assert_snapshot!(lines(&document(&[fit], &[], &Catalogue::new(Language::German))));
}

/// 12 s of positions from a sensor that clips them.
#[test]
fn a_sensor_that_clips_is_said() {
    let times = even_times(12.0, 1201).expect("times");
    let clipped = |range: f64, from: Option<f64>, language: Language| {
        let mut noise = noise(7);
        let samples = mixed().samples(&times).expect("samples");
        let value = |position: f64| (position + 5e-4 * noise()).clamp(-range, range);
        let values: Vec<f64> = samples.iter().map(|sample| sample.position).map(value).collect();
        let file = file("t (s),x (m)", &times, values.into_iter(), 0.0);
        let read = recordings(file.as_bytes(), &Choice::default()).expect("a recording").remove(0);
        let options = Options { from, ..Options::default() };
        let report = fit(&read.recording, &options).expect("a fit");
        let fit = Fitted::new("clipped.csv".to_owned(), read, report);
        sentences(&fit, &Catalogue::new(language)).join(" ")
    };
    let left_out = clipped(0.07, None, Language::English);
    let said = "The values stop at −7 cm and 7 cm at 5 turning points: the sensor clips there. \
                Only what follows, from";
    assert!(left_out.contains(said), "{left_out}");
    let asked = clipped(0.07, Some(0.02), Language::German);
    assert!(asked.contains("Dort schneidet der Sensor ab. Später beginnen, mit --from"), "{asked}");
    let most = clipped(0.04, None, Language::English);
    assert!(most.contains("the sensor clips there. "), "{most}");
    for sentences in [left_out, asked, most] {
        assert!(!sentences.contains("tukey") && !sentences.contains("release"), "{sentences}");
    }
}

#[test]
fn many_recordings_in_few_lines() {
    let file = positions(&mixed(), "t (s),x (m)", 5e-4);
    let mut fits: Vec<_> = (1..5).map(|i| fitted(&format!("data/{i}.csv"), &file)).collect();
    fits.push(fitted("data/pendulum.csv", &pendulum()));
    insta::assert_snapshot!(lines(&english(&fits)));
}

#[test]
fn names_that_only_folders_tell_apart_keep_them() {
    let file = positions(&mixed(), "t (s),x (m)", 5e-4);
    let fits = ["monday/a.csv", "tuesday/a.csv"].map(|name| fitted(name, &file));
    let headings: Vec<_> =
        english(&fits).sections.iter().map(|section| section.heading.clone()).collect();
    assert_eq!(headings[1..3], ["monday/a.csv", "tuesday/a.csv"]);
}

#[test]
fn pages_are_well_formed_in_both_languages_whatever_a_file_is_called() {
    let mixed = positions(&mixed(), "t (s),x <&$> (m)", 5e-4);
    let name = "5 $ <b> & \\$x$.csv";
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for count in [1, 2, 6] {
            let fits: Vec<_> = (0..count).map(|_| fitted(name, &mixed)).collect();
            let page = html::page(&document(&fits, &[], &catalogue), &catalogue).expect("a page");
            let page = page.replace("<!DOCTYPE html>", "");
            let wellformed = roxmltree::Document::parse(&closed(&page)).map(|_| ());
            assert!(wellformed.is_ok(), "{wellformed:?}");
            assert!(page.contains("5 $ &lt;b&gt; &amp; \\$x$.csv"), "the name as it is");
        }
    }
}

/// The page with the elements closed that HTML leaves open.
fn closed(page: &str) -> String {
    let mut closed = String::new();
    for (place, piece) in page.split("<meta ").enumerate() {
        let (tag, rest) =
            if place == 0 { ("", piece) } else { piece.split_once('>').expect("a tag") };
        closed += &if place == 0 { rest.to_owned() } else { format!("<meta {tag}/>{rest}") };
    }
    closed
}

/// What the recording shows of its swings against the turning points of the motion itself.
#[test]
fn measured_losses_are_those_of_the_turning_points() {
    let motion = mixed();
    let turns = motion.turning_points().map(|point| point.position.abs());
    let turns: Vec<f64> = std::iter::once(0.1).chain(turns).collect();
    let fit = fitted("m.csv", &positions(&motion, "t (s),x (m)", 0.0));
    let (swings, mean_of) = fit.report.swings(&fit.read.recording, 100);
    assert_eq!(mean_of, 1);
    assert!(swings.len() >= 8, "{swings:?}");
    for (n, swing) in swings.iter().enumerate() {
        // The release is no turning point of the recording, which begins there.
        let [a, b, c] = [turns[n + 1], turns[n + 2], turns[n + 3]];
        let (loss, amplitude) = ((a - c) / 2.0, (a + 2.0 * b + c) / 4.0);
        assert!((swing.loss - loss).abs() < 0.02 * loss, "{n}: {swing:?} {loss}");
        assert!((swing.amplitude - amplitude).abs() < 2e-3 * amplitude, "{n}: {swing:?}");
    }
}

/// Extremes of a velocity over ω0 lie where the laws say, with the coefficients of the truth.
#[test]
fn losses_of_a_velocity_lie_on_the_averaged_law_of_the_truth() {
    let omega = 40f64.sqrt();
    // Intercept 2f, slope πγ/ω0 and curvature 4κ/3.
    let laws: [(Friction, [f64; 3]); 3] = [
        (Coulomb::new(0.005, 0.005, WEIGHT).expect("a law").into(), [0.01 * 9.81 / 40.0, 0.0, 0.0]),
        (Stokes::new(0.1).expect("a law").into(), [0.0, std::f64::consts::PI * 0.1 / omega, 0.0]),
        (Newton::new(0.5).expect("a law").into(), [0.0, 0.0, 4.0 / 3.0]),
    ];
    for (friction, [intercept, slope, curvature]) in laws {
        let fit = fitted("v.csv", &velocities(&motion(friction), 0.0));
        let found = fit.report.best().expect("a fit").value("angular_frequency");
        assert!((found / omega - 1.0).abs() < 1e-3, "{found}");
        let (swings, _) = fit.report.swings(&fit.read.recording, 100);
        assert!(swings.len() >= 8, "{swings:?}");
        for swing in swings {
            let amplitude = swing.amplitude;
            let expected = intercept + amplitude * (slope + amplitude * curvature);
            let tolerance = 0.03 * expected + 2e-5;
            assert!((swing.loss - expected).abs() < tolerance, "{swing:?} {expected}");
        }
    }
}

#[test]
fn means_of_swings_keep_the_whole_loss() {
    let fit = fitted("m.csv", &positions(&mixed(), "t (s),x (m)", 5e-4));
    let (each, _) = fit.report.swings(&fit.read.recording, 1000);
    let (means, mean_of) = fit.report.swings(&fit.read.recording, 5);
    assert!(means.len() <= 5 && mean_of == each.len().div_ceil(5), "{mean_of}");
    let amplitudes = |swings: &[federpendel_fit::Swing]| {
        let reach = |pick: fn(f64, f64) -> f64| {
            swings.iter().map(|swing| swing.amplitude).reduce(pick).expect("swings")
        };
        (reach(f64::min), reach(f64::max))
    };
    let ((low, high), (mean_low, mean_high)) = (amplitudes(&each), amplitudes(&means));
    assert!(low <= mean_low && mean_high <= high);
}

/// What the ranking says of a mix is what the verdict says of the law that it lacks.
#[test]
fn a_mix_without_an_acting_law_is_rejected() {
    let report = fitted("m.csv", &positions(&mixed(), "t (s),x (m)", 5e-4)).report;
    for model in &report.models {
        let p = report.rejection(model.mix);
        match (model.mix.stokes && model.mix.coulomb, model.mix.newton) {
            (true, true) => assert_eq!(p, None),
            (true, false) => {
                assert!(p.is_some_and(|p| p >= LEVEL));
                assert_eq!(p, report.verdict.p_values[2]);
            }
            (false, _) => assert!(p.is_some_and(|p| p < LEVEL), "{:?}: {p:?}", model.mix),
        }
    }
}

/// A period that falls a little towards large swings is said with the verdict, not only among the details.
#[test]
fn a_slight_fault_is_said_with_the_verdict() {
    let times = even_times(20.0, 1001).expect("times");
    let value = |t: f64| {
        let ahead = 0.03 * (1.0 - (-0.2 * t).exp()) / 0.2;
        0.1 * (-0.1 * t).exp() * (5.0 * t + ahead).cos()
    };
    let fit = fitted("m.csv", &file("t (s),x (m)", &times, times.iter().map(|&t| value(t)), 5e-4));
    let said = sentences(&fit, &Catalogue::new(Language::English)).join(" ");
    assert!(said.starts_with("Viscous (Stokes) friction"), "{said}");
    assert!(
        said.contains("The period falls by 0.") && said.contains("more than their errors"),
        "{said}"
    );
}
