//! The page's experiments: presets, links, motions, what is refused.
//!
//! Run alone, as `./test` does, this package has only the sentences and features that the page has, and a sentence that
//! is missing there stops these tests.

use std::fs;
use std::path::Path;

use federpendel::parameter::PARAMETERS;
use federpendel_wasm::experiment::Laws;
use federpendel_wasm::motion::Solution;
use federpendel_wasm::words::{catalogue, read};
use federpendel_wasm::{Experiment, Refusal, compare, link, parameters, presets};

const LANGUAGES: [&str; 2] = ["en", "de"];

fn solve(experiment: &Experiment) -> Solution {
    Solution::new(experiment).unwrap_or_else(|error| panic!("{experiment:?}: {error}"))
}

fn preset(id: &str) -> Experiment {
    let found = presets::presets(catalogue("en")).into_iter().find(|preset| preset.id == id);
    found.unwrap_or_else(|| panic!("no preset {id}")).experiment
}

/// The values of an experiment file, read with the command line's own rules.
fn file(path: &str) -> Vec<(String, f64)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    let table: toml::Table = fs::read_to_string(path).unwrap().parse().unwrap();
    let mut values = Vec::new();
    let mut tables = vec![table];
    while let Some(table) = tables.pop() {
        for (name, value) in table {
            match value {
                toml::Value::Table(inner) => tables.push(inner),
                toml::Value::String(text) => {
                    values.push((name.clone(), read(catalogue("en"), &text, &name).unwrap()));
                }
                number => {
                    let number = number.as_float().or(number.as_integer().map(|n| n as f64));
                    values.push((name, number.unwrap()));
                }
            }
        }
    }
    values
}

#[test]
fn presets_are_the_experiments_of_the_command_line() {
    for (id, path) in [
        ("article-coulomb", "crates/federpendel-cli/src/experiment/built-in.toml"),
        ("block-on-table", "examples/sliding-block.toml"),
        ("all-three", "examples/all-frictions.toml"),
    ] {
        let experiment = preset(id);
        let values = file(path);
        assert!(values.len() >= 4, "{path}");
        for (name, value) in values {
            if !["duration", "samples"].contains(&name.as_str()) {
                assert_eq!(experiment.value(&name), value, "{id}: {name}");
            }
        }
    }
}

#[test]
fn every_preset_moves_and_is_told_in_both_languages() {
    for language in LANGUAGES {
        let catalogue = catalogue(language);
        let presets = presets::presets(catalogue);
        assert_eq!(presets.len(), 9);
        for preset in presets {
            let solution = solve(&preset.experiment);
            let summary = solution.summary(catalogue);
            assert!(!summary.sentence.is_empty() && !preset.label.starts_with("preset"));
            let samples = solution.samples(0.0, solution.duration(), 1001).unwrap();
            assert_eq!((samples.len(), samples[1000]), (4004, solution.duration()));
            // Energy and heat together stay what they were; the heats come from integrals of their own.
            let ledger = solution.ledger(solution.duration(), 101).unwrap();
            for i in 0..101 {
                let sum: f64 = (1..6).map(|column| ledger[column * 101 + i]).sum();
                assert!((sum / summary.energy - 1.0).abs() < 1e-12, "{}: {sum}", preset.id);
            }
            // Mass times acceleration is the sum of the forces.
            let now = solution.at(0.3 * solution.duration()).unwrap();
            let force = preset.experiment.value("mass") * now[2];
            assert!((now[8] - force).abs() < 1e-12, "{}", preset.id);
            let decrement = solution.decrement(catalogue).unwrap();
            assert_eq!(decrement.amplitude.len(), decrement.loss.len());
            assert!(decrement.parts.iter().all(|part| part.loss.len() == decrement.grid.len()));
        }
    }
}

/// Whether the spring carries a weight changes its pull and its energy, not the motion.
#[test]
fn a_spring_that_carries_the_mass_pulls_with_its_weight_too() {
    for id in ["article-coulomb", "all-three"] {
        let lying = preset(id);
        let hanging = Experiment { hanging: true, ..lying.clone() };
        let [mass, stiffness] = ["mass", "stiffness"].map(|name| hanging.value(name));
        let longer = mass * 9.81 / stiffness;
        let [lies, hangs] = [&lying, &hanging].map(solve);
        let ledger = hangs.ledger(hanging.duration, 51).unwrap();
        for i in 0..51 {
            let time = hanging.duration * (i as f64 / 50.0);
            let [flat, now] = [&lies, &hangs].map(|it| it.at(time).unwrap());
            // The guide is pressed by the same force in both, so they move alike.
            assert_eq!((&now[..3], &now[5..]), (&flat[..3], &flat[5..]), "{id}");
            assert_eq!((flat[4], now[4]), (0.0, mass * 9.81));
            assert!((now[3] + stiffness * (longer + now[0])).abs() < 1e-13, "{id}");
            assert!((now[3..8].iter().sum::<f64>() - now[8]).abs() < 1e-13, "{id}");
            // What the plot calls potential: the spring's energy, less that of the fall, from where it hangs at rest.
            let spring = |stretch: f64| stiffness * stretch * stretch / 2.0;
            let both = spring(longer + now[0]) - spring(longer) - mass * 9.81 * now[0];
            assert!((ledger[2 * 51 + i] - both).abs() < 1e-12, "{id}");
        }
    }
}

#[test]
fn at_rest_the_spring_carries_the_weight() {
    let mut experiment = Experiment { laws: Laws::default(), hanging: true, ..Default::default() };
    experiment.values.insert("position".to_owned(), 0.0);
    let now = solve(&experiment).at(1.0).unwrap();
    assert_eq!((now[3], now[4], now[8]), (-4.905, 4.905, 0.0));
    experiment.values.insert("gravity".to_owned(), -9.81);
    let refusal = Refusal::core(catalogue("en"), &Solution::new(&experiment).unwrap_err());
    assert_eq!(refusal.field, "gravity");
    experiment.hanging = false;
    assert_eq!(solve(&experiment).at(1.0).unwrap()[3..5], [0.0, 0.0]);
}

#[test]
fn critical_damping_leaves_no_period() {
    let mut experiment = preset("heavy-oil");
    let critical = experiment.critical_damping();
    for (damping, swings) in [(critical, false), (0.99 * critical, true)] {
        experiment.values.insert("damping".to_owned(), damping);
        assert_eq!(experiment.oscillator().unwrap().period().is_some(), swings);
    }
}

#[test]
fn links_give_back_every_bit() {
    let mut experiment = preset("all-three");
    experiment.hanging = true;
    for (place, (info, _, _)) in parameters::CONTROLS.iter().enumerate() {
        let awkward = 10f64.powi(3 * place as i32 - 15) / 3.0;
        experiment.values.insert(info.name.to_owned(), awkward);
    }
    experiment.duration = 0.1 + 0.2;
    let text = link::encode(&experiment);
    assert_eq!(link::decode(&text), Some(experiment.clone()));
    assert_eq!(link::decode(&format!("#{text}")), Some(experiment));
}

#[test]
fn old_links_keep_their_meaning() {
    let old = "1;mass=0.25;stiffness=12.0;position=0.08;velocity=-0.1;gravity=9.81;normal_force=4.905;damping=0.02;\
               kinetic=0.01;static=0.015;density=1.2;drag_coefficient=1.1;area=0.005;laws=stokes+coulomb;hanging=no;\
               duration=20.0";
    let experiment = link::decode(old).unwrap();
    assert_eq!(link::encode(&experiment), old);
    assert_eq!(experiment.laws, Laws { stokes: true, coulomb: true, newton: false });
}

#[test]
fn links_that_are_broken_or_of_the_future_do_no_harm() {
    for unknown in ["", "2;mass=1", "mass=1", "10;mass=1", "x"] {
        assert_eq!(link::decode(unknown), None, "{unknown}");
    }
    let with = |text: &str| link::decode(text).unwrap();
    assert_eq!(with("1"), Experiment::default());
    for ignored in ["1;colour=red", "1;mass", "1;;="] {
        assert_eq!(with(ignored), Experiment::default(), "{ignored}");
    }
    for wrong in ["1;mass=-2", "1;mass=NaN", "1;mass=inf", "1;duration=0", "1;laws=stokes-coulomb"]
    {
        assert_eq!(link::decode(wrong), None, "{wrong}");
    }
    let mailed = with("1;laws=stokes newton").laws;
    assert_eq!(mailed, Laws { stokes: true, coulomb: false, newton: true });
    assert_eq!(with("1;colour=red;mass=2").value("mass"), 2.0);
    assert_eq!(with("1;laws=none").laws, Laws::default());
}

#[test]
fn what_is_refused_names_its_field() {
    for (name, value, field) in [
        ("mass", -1.0, "mass"),
        ("stiffness", f64::NAN, "stiffness"),
        ("static", 0.01, "static"),
        ("gravity", 0.0, "gravity"),
        ("position", f64::INFINITY, "position"),
    ] {
        let mut experiment = Experiment::default();
        experiment.values.insert(name.to_owned(), value);
        let error = Solution::new(&experiment).unwrap_err();
        for language in LANGUAGES {
            let refusal = Refusal::core(catalogue(language), &error);
            assert_eq!(refusal.field, field, "{refusal:?}");
            assert!(refusal.message.len() > 20, "{refusal:?}");
        }
    }
    let experiment = Experiment { duration: -1.0, ..Experiment::default() };
    let error = Solution::new(&experiment).unwrap_err();
    assert_eq!(Refusal::core(catalogue("en"), &error).field, "duration");
}

#[test]
fn a_record_of_more_swings_than_a_page_follows_is_refused() {
    let mut experiment = Experiment::default();
    experiment.laws.newton = true;
    experiment.values.insert("stiffness".to_owned(), 1e12);
    let error = Solution::new(&experiment).unwrap_err();
    assert_eq!(Refusal::core(catalogue("en"), &error).field, "duration");
    experiment.duration = 1e-2;
    let solution = solve(&experiment);
    assert!(solution.summary(catalogue("en")).sentence.contains("not followed further"));
}

#[test]
fn at_turning_points_the_mass_stands() {
    let solution = solve(&Experiment::default());
    let turns = solution.turning_points(10);
    let (times, _) = turns.split_at(turns.len() / 2);
    assert_eq!(times.len(), 10);
    for time in times {
        let [_, velocity, acceleration, ..] = solution.at(*time).unwrap()[..] else { panic!() };
        assert_eq!(velocity, 0.0, "{time}");
        // A millionth of a period beside it the mass moves.
        let beside = solution.at(time + 1e-6).unwrap()[1];
        let gained = 1e-6 * acceleration;
        assert!((beside - gained).abs() <= 1e-3 * gained.abs(), "{time}: {beside}, {gained}");
    }
}

#[test]
fn stokes_friction_alone_is_one_of_three_cases() {
    let laws = Laws { stokes: true, ..Laws::default() };
    let mut experiment = Experiment { laws, ..Experiment::default() };
    for (damping, english, german) in [
        (0.1, "underdamped: damping ratio 0.0158", "Schwingfall: Dämpfungsgrad 0,0158"),
        (experiment.critical_damping(), "critically damped", "aperiodische Grenzfall"),
        (40.0, "overdamped: damping ratio 6.32", "Kriechfall: Dämpfungsgrad 6,32"),
    ] {
        experiment.values.insert("damping".to_owned(), damping);
        for (language, words) in [("en", english), ("de", german)] {
            let sentence = solve(&experiment).summary(catalogue(language)).sentence;
            assert!(sentence.contains(words), "{sentence}");
        }
    }
}

#[test]
fn what_the_page_shows_can_be_typed() {
    let german = catalogue("de");
    for (written, value) in [("4,905", 4.905), ("1,250 kg", 1.25), ("4.905", 4.905)] {
        assert_eq!(read(german, written, "mass").ok(), Some(value), "{written}");
    }
    // In English a comma may separate thousands.
    assert!(read(catalogue("en"), "4,905", "mass").is_err());
    assert!(read(german, "1.000,5", "mass").is_err());
}

#[test]
fn what_is_typed_is_read_as_everywhere() {
    let english = catalogue("en");
    for (written, name, value) in [
        ("12.5", "position", 12.5),
        ("12,5 cm", "position", 0.125),
        (" -3 mm", "position", -0.003),
        ("250 g", "mass", 0.25),
        ("5 cm^2", "area", 5e-4),
        ("2 %", "kinetic", 0.02),
        ("10 ms", "dt", 0.01),
    ] {
        assert_eq!(read(english, written, name), Ok(value), "{written}");
    }
    for written in ["", "abc", "0 kg", "-1", "1,000.5", "3 m", "1e999"] {
        for language in LANGUAGES {
            let refusal = read(catalogue(language), written, "mass").unwrap_err();
            assert_eq!(refusal.field, "mass");
            assert!(refusal.message.contains("kg"), "{written}: {}", refusal.message);
        }
    }
}

#[test]
fn every_method_is_told_or_refused() {
    let (coulomb, all) = (solve(&Experiment::default()), solve(&preset("all-three")));
    for language in LANGUAGES {
        for method in compare::methods(catalogue(language)) {
            let found =
                compare::compare(&coulomb, catalogue(language), method.id, 0.01, 200).unwrap();
            assert_eq!(found.numbers.len(), 600);
            let largest = found.numbers[400..].iter().fold(0.0, |most: f64, e| most.max(e.abs()));
            // The printed formula is wrong by the factor C.
            assert!((1e-9..3.0).contains(&largest), "{}: {largest}", method.id);
            assert!(found.sentences.len() > 1 && !method.label.contains("method"), "{method:?}");
            let beyond = compare::compare(&all, catalogue(language), method.id, 0.01, 200);
            // The article has no formula for three laws at once.
            assert_eq!(beyond.is_err(), method.order.is_none(), "{}", method.id);
        }
    }
    for (name, step) in [
        ("no-such", 0.01),
        ("rk4", 0.0),
        ("rk4", f64::NAN),
        ("article-scheme", 1e-30),
        ("rk4", 2e-5),
    ] {
        assert!(
            compare::compare(&coulomb, catalogue("en"), name, step, 200).is_err(),
            "{name} {step}"
        );
    }
}

#[test]
fn what_is_only_rounding_is_called_so() {
    let mut experiment = Experiment { laws: Laws::default(), ..Experiment::default() };
    let mut said = |laws: Laws, method: &str| {
        experiment.laws = laws;
        let found = compare::compare(&solve(&experiment), catalogue("en"), method, 0.01, 200);
        found.unwrap().sentences.join(" ").contains("only rounding")
    };
    assert!(said(Laws::default(), "article-corrected"));
    assert!(!said(Laws::default(), "verlet"));
    assert!(!said(Laws { coulomb: true, ..Laws::default() }, "article-corrected"));
}

#[test]
fn sliders_stay_within_what_is_allowed() {
    for parameter in parameters::parameters(catalogue("de")) {
        let (slider, value) = (parameter.slider, parameter.value);
        assert!(slider.low < slider.high && !(slider.logarithmic && slider.low <= 0.0));
        assert!((slider.low..=slider.high).contains(&value), "{}", parameter.name);
        let info = PARAMETERS.iter().find(|info| info.name == parameter.name).unwrap();
        assert!(info.range.contains(slider.low) && info.range.contains(slider.high));
    }
}
