//! Further plots of one motion: phase portrait, energy, loss of amplitude.

use federpendel::{
    Coulomb, Friction, Ledger, Motion, Newton, NormalForce, Oscillator, State, Stokes,
};
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::plot::{
    AveragedLaw, Course, CoursesData, DecrementData, EnergyData, Losses, LossesData, PhaseData,
    Plot, Role, swings,
};
use federpendel_text::{Catalogue, Language};

fn all() -> Friction {
    Friction {
        stokes: Some(Stokes::new(0.05).expect("a law")),
        coulomb: Some(Coulomb::new(0.002, 0.003, NormalForce::Weight(9.81)).expect("a law")),
        newton: Some(Newton::new(0.235).expect("a law")),
    }
}

fn motion(friction: impl Into<Friction>, position: f64) -> Motion {
    let oscillator = Oscillator::new(0.5, 20.0, friction).expect("an oscillator");
    Motion::new(oscillator, State::new(position, 0.0).expect("a state")).expect("a motion")
}

/// Every back end draws `plot`.
fn assert_drawn(plot: &Plot) {
    assert!(!plot.title.is_empty() && plot.description.contains(&plot.title), "{plot:?}");
    for background in [Background::Light, Background::Dark] {
        let text = svg(plot, Size::of(plot), background);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        assert!(roxmltree::Document::parse(&text).is_ok());
    }
    assert!(png(plot, Size::of(plot), Background::Light, 1.0).is_ok());
    for columns in [50, 80, 120] {
        let text = terminal(plot, columns, 24, false);
        for line in text.lines() {
            assert!(line.chars().count() <= columns.max(55), "{line}");
        }
    }
}

fn phase(language: Language, motion: &Motion, duration: f64) -> Plot {
    let at = |i: u32| motion.at(duration * f64::from(i) / 2000.0).expect("a state");
    let states: Vec<State> = (0..=2000)
        .map(at)
        .map(|sample| State { position: sample.position, velocity: sample.velocity })
        .collect();
    let turning_points: Vec<_> =
        motion.turning_points().take_while(|point| point.time <= duration).collect();
    let data = PhaseData {
        mix: motion.oscillator().friction().mix(),
        states: &states,
        turning_points: &turning_points,
        outcome: &motion.outcome(),
        sticking_offset: motion.oscillator().sticking_offset(),
    };
    Plot::phase(&Catalogue::new(language), &data)
}

#[test]
fn the_phase_portrait_marks_release_turning_points_rest_and_the_sticking_band() {
    let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81)).expect("a law");
    for language in Language::ALL {
        let plot = phase(language, &motion(dry, 0.1), 6.0);
        assert_drawn(&plot);
        let series: Vec<_> =
            plot.series.iter().map(|series| (series.role, series.points.len())).collect();
        let expected = [
            (Role::Exact, 2001),
            (Role::TurningPoints, 9),
            (Role::Release, 1),
            (Role::Rest, 1),
            (Role::Sticking, 201),
        ];
        assert_eq!(series, expected);
        let (first, last) = (plot.series[4].points[0].0, plot.series[4].points[200].0);
        assert!((first + 0.4905).abs() < 1e-9 && (last - 0.4905).abs() < 1e-9);
        assert!(plot.series[4].name.contains(if language == Language::German {
            "4,905 mm"
        } else {
            "4.905 mm"
        }));
    }
    // The record ends before the rest.
    let plot = phase(Language::German, &motion(dry, 0.1), 2.0);
    assert!(plot.series.iter().all(|series| series.role != Role::Rest));
    // A band far wider than the motion leaves the motion to be seen.
    let strong = Coulomb::new(0.2, 0.3, NormalForce::Weight(9.81)).expect("a law");
    let plot = phase(Language::German, &motion(strong, 0.001), 1.0);
    assert_drawn(&plot);
    let bar = plot.series.last().expect("a bar");
    assert!(bar.points[1].0 < 2.0 && bar.name == "Haftbereich ±7,357 cm", "{bar:?}");
}

#[test]
fn shares_of_the_energy_add_up_to_that_of_the_release() {
    let motion = motion(all(), 0.1);
    let times: Vec<f64> = (0..=500).map(|i| 0.02 * f64::from(i)).collect();
    let ledgers = motion.ledger(&times).expect("ledgers");
    let data = EnergyData { mix: all().mix(), ledgers: &ledgers };
    for language in Language::ALL {
        let plot = Plot::energy(&Catalogue::new(language), &data);
        assert_drawn(&plot);
        let roles: Vec<_> = plot.series.iter().map(|series| series.role).collect();
        let expected = [Role::Kinetic, Role::Potential, Role::Stokes, Role::Coulomb, Role::Newton];
        assert_eq!(roles, expected);
        // The top is the energy of the release, ½Cx0² = 100 mJ, and each area stands on the next.
        for point in &plot.series[0].points {
            assert!((point.1 - 100.0).abs() < 1e-9, "{point:?}");
        }
        for pair in plot.series.windows(2) {
            let below: Vec<_> = pair[1].points.iter().map(|point| point.1).collect();
            assert_eq!(pair[0].lower.as_ref(), Some(&below));
        }
        assert!(plot.series[4].lower.iter().flatten().all(|floor| *floor == 0.0));
        // Without colour: five areas, five patterns.
        let text = terminal(&plot, 80, 24, false);
        for sample in ["⠁ ⠁", "⡇⡇⡇", "⠒⠒⠒", "⣿⣿⣿", "⢕⢕⢕"] {
            assert!(text.contains(&format!("{sample} ")), "{text}");
        }
    }
    let plot = Plot::energy(
        &Catalogue::new(Language::German),
        &EnergyData { mix: Friction::NONE.mix(), ledgers: &ledgers },
    );
    assert_eq!(plot.series.len(), 2);
    for ledgers in [&[] as &[Ledger], &ledgers[..1]] {
        let data = EnergyData { mix: all().mix(), ledgers };
        assert_drawn(&Plot::energy(&Catalogue::new(Language::English), &data));
    }
}

fn decrement(language: Language, motion: &Motion, count: usize) -> Plot {
    let release = std::iter::once(motion.release().position);
    let turns = motion.turning_points().map(|point| point.position);
    let amplitudes: Vec<f64> = release.chain(turns).take(count + 1).collect();
    let law = AveragedLaw::of(motion.oscillator());
    let data = DecrementData { law, swings: &swings(&amplitudes), mean_of: 1, length: "m" };
    Plot::decrement(&Catalogue::new(language), &data)
}

#[test]
fn swings_lie_on_the_averaged_law() {
    let motion = motion(all(), 0.1);
    let plot = decrement(Language::German, &motion, 25);
    assert_drawn(&plot);
    let names: Vec<_> = plot.series.iter().map(|series| series.name.as_str()).collect();
    let expected = [
        "Halbschwingungen",
        "Gemitteltes Gesetz ΔA = 2f + (πγ/ω₀) A + (4/3) κ A²",
        "Achsenabschnitt 2f = 981 µm (Coulomb)",
        "Steigung πγ/ω₀ = 0,02484 (Stokes)",
        "Krümmung (4/3)κ = 0,6267 1/m (Newton)",
    ];
    assert_eq!(names, expected);
    // Where the losses are small the real ones follow the law to second order.
    let law = &plot.series[1].points;
    for (amplitude, loss) in &plot.series[0].points {
        let after = law.partition_point(|point| point.0 < *amplitude);
        let ((x, low), (next, high)) = (law[after - 1], law[after]);
        let expected = low + (high - low) * (amplitude - x) / (next - x);
        assert!((loss / expected - 1.0).abs() < 0.01, "{amplitude} {loss} {expected}");
    }
}

#[test]
fn only_laws_that_act_are_named_and_many_swings_are_marked_in_part() {
    let stokes = Stokes::new(0.002).expect("a law");
    let plot = decrement(Language::English, &motion(stokes, 0.1), 300);
    assert_drawn(&plot);
    let roles: Vec<_> = plot.series.iter().map(|series| series.role).collect();
    assert_eq!(roles, [Role::Swings, Role::Stokes]);
    assert_eq!(plot.series[0].name, "Swings (1 in 7)");
    assert!(plot.description.contains("300 swings lose"), "{}", plot.description);
    let plot = decrement(Language::English, &motion(Friction::NONE, 0.1), 10);
    assert_drawn(&plot);
    assert_eq!(plot.series.len(), 1);
}

#[test]
fn without_a_swing_the_plot_says_so() {
    for (language, why) in [
        (Language::German, "weniger als zwei Amplituden"),
        (Language::English, "fewer than two amplitudes"),
    ] {
        let plot = decrement(language, &motion(all(), 0.0001), 0);
        assert_drawn(&plot);
        assert!(plot.series.is_empty() && plot.notes[0].text.contains(why));
        assert!(terminal(&plot, 80, 24, false).contains(why));
        assert!(svg(&plot, Size::default(), Background::Light).contains(why));
    }
}

#[test]
fn several_motions_are_told_apart_without_colour() {
    let times = [0.0, 1.0, 2.0, 3.0];
    let (swings, creeps) = ([0.1, -0.05, 0.02, -0.01], [0.1, 0.01, 0.001, 1e-9]);
    let course = |name, role, positions| Course { name, role, times: &times, positions };
    let curves = [
        course("Schwingfall", Role::Comparison(0), &swings),
        course("Kriechfall", Role::Comparison(1), &creeps),
        course("Coulomb", Role::Coulomb, &swings),
    ];
    let data = CoursesData { title: "Drei Fälle?", curves: &curves };
    let plot = Plot::courses(&Catalogue::new(Language::German), &data);
    assert_drawn(&plot);
    for (n, series) in plot.series.iter().enumerate() {
        let before = &plot.series[..n];
        assert!(
            before.iter().all(|other| other.style != series.style && other.role != series.role)
        );
    }
    assert_eq!(
        plot.description,
        "„Drei Fälle?“: Auslenkung über 3 s. Schwingfall: ab 10 cm, zwischen −5 cm und 10 cm, am Ende \
         −1 cm; Kriechfall: ab 10 cm, zwischen 0 m und 10 cm, am Ende 0 m; Coulomb: ab 10 cm, zwischen \
         −5 cm und 10 cm, am Ende −1 cm."
    );
    let none = CoursesData { title: "nichts", curves: &[] };
    assert_drawn(&Plot::courses(&Catalogue::new(Language::English), &none));
}

#[test]
fn losses_of_each_law_have_its_shape() {
    let stokes = Stokes::new(0.05).expect("a law");
    let dry = Coulomb::new(0.002, 0.002, NormalForce::Weight(9.81)).expect("a law");
    let drag = Newton::new(0.235).expect("a law");
    let named: [(&str, Role, Motion); 3] = [
        ("S", Role::Stokes, motion(stokes, 0.1)),
        ("C", Role::Coulomb, motion(dry, 0.1)),
        ("N", Role::Newton, motion(drag, 0.1)),
    ];
    let amplitudes = named.each_ref().map(|(_, _, motion)| -> Vec<f64> {
        let turns = motion.turning_points().map(|point| point.position).take(60);
        std::iter::once(motion.release().position).chain(turns).collect()
    });
    let losses: Vec<_> = named
        .iter()
        .zip(&amplitudes)
        .map(|((name, role, motion), amplitudes)| Losses {
            name,
            role: *role,
            oscillator: motion.oscillator(),
            amplitudes,
        })
        .collect();
    for language in Language::ALL {
        let plot = Plot::losses(&Catalogue::new(language), &LossesData { motions: &losses });
        assert_drawn(&plot);
        let names: Vec<_> = plot.series.iter().map(|series| series.name.as_str()).collect();
        let expected = ["S: ΔA = (πγ/ω₀) A", "", "C: ΔA = 2f", "", "N: ΔA = (4/3) κ A²", ""];
        assert_eq!(names, expected);
        // At half the amplitude a half, the whole and a quarter of the loss, of the law and of its swings.
        for (pair, share) in plot.series.chunks(2).zip([0.5, 1.0, 0.25]) {
            let [swings, law] = pair else { panic!("{pair:?}") };
            let (half, whole) = (law.points[50].1, law.points[100].1);
            assert!((half / whole - share).abs() < 1e-9, "{half} {whole}");
            for (amplitude, loss) in &swings.points {
                let after = law.points.partition_point(|point| point.0 < *amplitude);
                let ((x, low), (next, high)) = (law.points[after - 1], law.points[after]);
                let expected = low + (high - low) * (amplitude - x) / (next - x);
                assert!((loss / expected - 1.0).abs() < 0.02, "{amplitude} {loss} {expected}");
            }
            assert!(swings.points.len() <= 24);
        }
    }
    let nothing = Plot::losses(&Catalogue::new(Language::German), &LossesData { motions: &[] });
    assert_drawn(&nothing);
    assert!(nothing.notes[0].text.contains("weniger als zwei Amplituden"));
}
