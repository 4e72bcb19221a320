//! Drawings show what the physics says, within their frames.

use federpendel_report::sketch::{Given, Law, Side, guide, loss, stream};
use federpendel_text::{Catalogue, Language};
use roxmltree::{Document, Node};

const LAWS: [Law; 4] = [Law::None, Law::Stokes, Law::Coulomb, Law::Newton];

fn given() -> Given {
    let value = |text: &str| text.to_owned();
    Given {
        start: value("10 cm"),
        turn: value("9 cm"),
        start_energy: value("100 mJ"),
        turn_energy: value("81 mJ"),
        work: value("19 mJ < 1 J"),
    }
}

fn every_drawing(language: Language) -> Vec<String> {
    let catalogue = Catalogue::new(language);
    let guides = LAWS.into_iter().flat_map(|law| [(law, Side::Left), (law, Side::Right)]);
    guides
        .map(|(law, side)| guide("a", law, side, &catalogue))
        .chain([loss("b", &given(), &catalogue), stream("c", &catalogue)])
        .collect()
}

/// The points of a path.
fn points(path: Node) -> Vec<(f64, f64)> {
    let numbers: Vec<f64> = path
        .attribute("d")
        .expect("a path")
        .split(['M', 'L', 'Z', ' '])
        .filter(|number| !number.is_empty())
        .map(|number| number.parse().expect("a number"))
        .collect();
    numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
}

/// The first and the last point of the first arrow of a class.
fn arrow(drawing: &Document, class: &str) -> Option<[(f64, f64); 2]> {
    let group = drawing.descendants().find(|node| node.attribute("class") == Some(class))?;
    let shaft = points(group.children().find(|node| node.has_tag_name("path"))?);
    Some([shaft[0], shaft[1]])
}

fn direction(arrow: [(f64, f64); 2]) -> f64 {
    (arrow[1].0 - arrow[0].0).signum()
}

#[test]
fn drawings_have_a_name_and_stay_in_their_frames() {
    for drawing in Language::ALL.into_iter().flat_map(every_drawing) {
        let drawing = Document::parse(&drawing).expect("well-formed");
        let root = drawing.root_element();
        let side = |name| root.attribute(name).expect("a size").parse::<f64>().expect("a number");
        let (width, height) = (side("width"), side("height"));
        for path in drawing.descendants().filter(|node| node.has_tag_name("path")) {
            for (x, y) in points(path) {
                assert!((0.0..=width).contains(&x) && (0.0..=height).contains(&y), "{x} {y}");
            }
        }
        let named: Vec<_> = root.attribute("aria-labelledby").expect("names").split(' ').collect();
        let ids = root.children().filter_map(|node| node.attribute("id"));
        assert_eq!(ids.collect::<Vec<_>>(), named);
    }
}

#[test]
fn friction_is_against_the_velocity_and_the_spring_pulls_back() {
    let catalogue = Catalogue::new(Language::German);
    for law in LAWS {
        for (side, back) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
            let svg = guide("a", law, side, &catalogue);
            let drawing = Document::parse(&svg).expect("well-formed");
            let way = |class| arrow(&drawing, class).map(direction);
            assert_eq!(way("velocity"), Some(back));
            assert_eq!(way("force elastic"), Some(back));
            assert_eq!(way("force friction"), (law != Law::None).then_some(-back), "{law:?}");
        }
    }
}

#[test]
fn only_dry_friction_acts_where_the_mass_touches_the_guide() {
    let catalogue = Catalogue::new(Language::English);
    for law in LAWS {
        let svg = guide("a", law, Side::Right, &catalogue);
        let drawing = Document::parse(&svg).expect("well-formed");
        // The normal force begins at the guide, the spring force in the middle of the mass.
        let mass = drawing.descendants().find(|node| node.attribute("class") == Some("mass"));
        let outline = points(mass.and_then(|mass| mass.first_child()).expect("the mass"));
        let (foot, top) = (outline[0].1, outline[1].1);
        let Some([from, _]) = arrow(&drawing, "force friction") else {
            assert_eq!(law, Law::None);
            continue;
        };
        let up = (foot - from.1) / (foot - top);
        assert_eq!(up < 0.1, law == Law::Coulomb, "{law:?} acts at {up} of the height");
    }
}

#[test]
fn what_is_given_stands_in_the_drawing() {
    let svg = loss("b", &given(), &Catalogue::new(Language::English));
    let drawing = Document::parse(&svg).expect("well-formed");
    let labels: Vec<String> = drawing
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|text| {
            text.descendants().filter(Node::is_text).filter_map(|node| node.text()).collect()
        })
        .collect();
    for label in
        ["x0 = 10 cm", "x1 = 9 cm", "½Cx0² = 100 mJ", "½Cx1² = 81 mJ", "FR (x0 + x1) = 19 mJ < 1 J"]
    {
        assert!(labels.iter().any(|found| found == label), "{label}: {labels:?}");
    }
}
