//! Fewer bytes for the same picture, and ids that are unlike those of other pictures on a page.

use kuva::render::render::{PathData, Primitive, Scene};

use super::path::{Point, path, simplified};

/// Writes lines and areas with no more points than their shape needs.
pub(super) fn paths(scene: &mut Scene) {
    for element in &mut scene.elements {
        match element {
            Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray } => {
                let path = PathData {
                    d: path(&simplified(points)),
                    fill: None,
                    stroke: stroke.clone(),
                    stroke_width: *stroke_width,
                    opacity: None,
                    stroke_dasharray: stroke_dasharray.take(),
                };
                *element = Primitive::Path(Box::new(path));
            }
            Primitive::Path(path_data) => {
                if let Some(points) = outline(&path_data.d) {
                    path_data.d = path(&simplified(&points)) + "z";
                }
            }
            _ => {}
        }
    }
}

/// Makes the ids of the scene of `id`: those of kuva count all pictures drawn so far, so that the same plot would
/// be written differently.
pub(super) fn ids(scene: &mut Scene, id: &str) {
    let clips = scene.elements.iter_mut().filter_map(|element| match element {
        Primitive::ClipStart { id, .. } => Some(id),
        _ => None,
    });
    for (number, clip) in clips.enumerate() {
        let theirs = format!("\"{clip}\"");
        *clip = format!("{id}-clip-{number}");
        for definition in &mut scene.defs {
            *definition = definition.replace(&theirs, &format!("\"{clip}\""));
        }
    }
}

/// The points of a path that is one closed line of straight pieces in absolute coordinates.
fn outline(path: &str) -> Option<Vec<Point>> {
    let numbers: Vec<f64> = path
        .strip_prefix('M')?
        .strip_suffix('Z')?
        .split([' ', 'L', ','])
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().ok())
        .collect::<Option<_>>()?;
    let pairs = numbers.chunks_exact(2);
    pairs.remainder().is_empty().then(|| pairs.map(|pair| (pair[0], pair[1])).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_are_closed_lines_of_straight_pieces() {
        assert_eq!(
            outline("M 1.5 2 L 3 4 L 5 6 Z"),
            Some(vec![(1.5, 2.0), (3.0, 4.0), (5.0, 6.0)])
        );
        assert_eq!(outline("M 1 2 A 3 4 5 6 Z"), None);
        assert_eq!(outline("M 1 2 L 3 Z"), None);
    }
}
