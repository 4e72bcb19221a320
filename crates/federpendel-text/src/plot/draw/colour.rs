//! Colours by role. They are those of Okabe and Ito, or near them, which people who see fewer colours
//! tell apart too; dashes and markers say the same once more.

#[cfg(feature = "pictures")]
use kuva::render::theme::Theme;

use crate::plot::Role;

/// What a picture is drawn on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Background {
    /// White.
    #[default]
    Light,
    /// Nearly black.
    Dark,
}

/// Where the colours of a picture come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Palette {
    /// They are fixed, for this background.
    Fixed(Background),
    /// They are custom properties of the page that the picture stands in; it has no background of its own.
    #[cfg(feature = "pictures")]
    Page,
}

/// What has a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Paint {
    /// A series.
    Series(Role),
    /// A band, to be drawn over whatever is behind it.
    Band,
    /// Texts.
    Text,
    /// Axes and ticks.
    Axis,
    /// The lines of the grid.
    Grid,
}

/// Colours of what is held beside the exact motion, on light and dark. Far from its blue in lightness too, since
/// they lie on it; neighbours differ in lightness as well as in hue.
const COMPARISONS: [(&str, &str); 12] = [
    ("#00402b", "#e9ff9c"),
    ("#d55e00", "#ff9248"),
    ("#8a5a9e", "#d3a4e6"),
    ("#009e73", "#1fc08e"),
    ("#5c1a00", "#ffd9c2"),
    ("#c9709f", "#ff7fb6"),
    ("#2f2483", "#a9a2ff"),
    ("#a08000", "#e0b83a"),
    ("#7a1f4b", "#d0567f"),
    ("#5f7f1f", "#a4c95a"),
    ("#222222", "#f2f2f2"),
    ("#808080", "#a0a0a0"),
];

/// The name of a paint in custom properties, and its colours on light and dark as `#rrggbb`.
fn look(paint: Paint) -> (String, &'static str, &'static str) {
    let (name, light, dark) = match paint {
        Paint::Band => ("band", "#d9d9d9", "#444a50"),
        Paint::Text => ("text", "#000000", "#e0e0e0"),
        Paint::Axis => ("axis", "#000000", "#cccccc"),
        Paint::Grid => ("grid", "#e6e6e6", "#3a3a3a"),
        Paint::Series(role) => match role {
            Role::Exact => ("exact", "#0072b2", "#56b4e9"),
            Role::Envelope => ("envelope", "#c05200", "#f0a24a"),
            Role::TurningPoints => ("turning-points", "#222222", "#f2f2f2"),
            Role::Swings => ("swings", "#222222", "#f2f2f2"),
            Role::Release => ("release", "#00664b", "#7be0bd"),
            Role::Rest => ("rest", "#b3006b", "#ff8fd0"),
            Role::Experiment => ("experiment", "#b3006b", "#ff8fd0"),
            Role::Sticking => ("sticking", "#b4b4b4", "#70787f"),
            // Neighbours in a stack of areas differ in lightness.
            Role::Kinetic => ("kinetic", "#f0e442", "#f0e442"),
            Role::Potential => ("potential", "#56b4e9", "#3d8fc4"),
            Role::Stokes => ("stokes", "#00b383", "#2bc397"),
            Role::Coulomb => ("coulomb", "#d55e00", "#ee7a1e"),
            Role::Newton => ("newton", "#7b3f73", "#c98bc0"),
            Role::Guide => ("guide", "#5a5a5a", "#b4b4b4"),
            Role::Comparison(n) => {
                let n = n % COMPARISONS.len();
                return (format!("comparison-{n}"), COMPARISONS[n].0, COMPARISONS[n].1);
            }
        },
    };
    (name.to_owned(), light, dark)
}

/// A colour as CSS has it.
pub(super) fn css(paint: Paint, palette: Palette) -> String {
    let (_, light, dark) = look(paint);
    match palette {
        Palette::Fixed(Background::Light) => light.to_owned(),
        Palette::Fixed(Background::Dark) => dark.to_owned(),
        #[cfg(feature = "pictures")]
        Palette::Page => format!("var(--plot-{})", look(paint).0),
    }
}

/// The custom properties from which [`inline`](super::inline) takes its colours, as declarations for a rule of
/// the page's stylesheet: `--plot-exact:#0072b2;…`.
pub fn palette(background: Background) -> String {
    use Role::*;
    let roles = [
        Exact,
        Envelope,
        TurningPoints,
        Swings,
        Release,
        Rest,
        Experiment,
        Sticking,
        Kinetic,
        Potential,
        Stokes,
        Coulomb,
        Newton,
        Guide,
    ];
    let comparisons = (0..COMPARISONS.len()).map(Comparison);
    [Paint::Band, Paint::Text, Paint::Axis, Paint::Grid]
        .into_iter()
        .chain(roles.into_iter().chain(comparisons).map(Paint::Series))
        .map(|paint| {
            let colour = css(paint, Palette::Fixed(background));
            format!("--plot-{}:{colour};", look(paint).0)
        })
        .collect()
}

/// Colours of axes, texts and the background.
#[cfg(feature = "pictures")]
pub(super) fn theme(palette: Palette) -> Theme {
    let theme = match palette {
        Palette::Fixed(Background::Dark) => Theme::dark(),
        Palette::Fixed(Background::Light) | Palette::Page => Theme::light(),
    };
    Theme {
        axis_color: css(Paint::Axis, palette),
        tick_color: css(Paint::Axis, palette),
        grid_color: css(Paint::Grid, palette),
        text_color: css(Paint::Text, palette),
        font_family: Some("sans-serif".into()),
        ..theme
    }
}

/// The colour of a role in a terminal, as the number of an ANSI escape: the sixteen that the user's
/// own palette defines, so that they suit its background.
pub(super) fn ansi(role: Role) -> u8 {
    const COMPARISONS: [u8; 12] = [31, 32, 34, 33, 35, 91, 92, 94, 93, 95, 39, 90];
    match role {
        Role::Exact | Role::Potential => 36,
        Role::Envelope | Role::Kinetic => 33,
        Role::TurningPoints | Role::Swings | Role::Guide => 39,
        Role::Rest | Role::Experiment | Role::Newton => 35,
        Role::Release | Role::Stokes => 32,
        Role::Coulomb => 31,
        Role::Sticking => 90,
        Role::Comparison(n) => COMPARISONS[n % COMPARISONS.len()],
    }
}
