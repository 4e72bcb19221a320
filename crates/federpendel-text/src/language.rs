//! The languages that the catalogue speaks, and which of them the user wants.

use unic_langid::LanguageIdentifier;

/// A language of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English, with a decimal point.
    #[default]
    English,
    /// German, with a decimal comma.
    German,
}

impl Language {
    /// All languages.
    pub const ALL: [Language; 2] = [Language::English, Language::German];

    /// The language's tag, `en` or `de`.
    pub fn tag(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::German => "de",
        }
    }

    /// The language of a tag or locale name: `de`, `de-AT`, `de_DE.UTF-8`; `None` if the catalogue
    /// does not speak it.
    pub fn from_tag(tag: &str) -> Option<Self> {
        let primary = tag.split(['-', '_', '.', '@']).next()?;
        Self::ALL.into_iter().find(|language| primary.eq_ignore_ascii_case(language.tag()))
    }

    /// The language that the environment asks for, by the rules of gettext: the locale is the first
    /// of `LC_ALL`, `LC_MESSAGES`, `LANG` that is not empty; unless it is `C`, the list in `LANGUAGE`
    /// goes before it. English where nothing fits.
    ///
    /// `lookup` gives the value of a variable, for example `|name| std::env::var(name).ok()`.
    pub fn from_environment(lookup: impl Fn(&str) -> Option<String>) -> Self {
        let set = |name: &str| lookup(name).filter(|value| !value.is_empty());
        let Some(locale) = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().find_map(set) else {
            return Self::default();
        };
        if matches!(locale.split(['.', '@']).next(), Some("C" | "POSIX")) {
            return Self::default();
        }
        let preferred = set("LANGUAGE").unwrap_or_default();
        preferred.split(':').chain([locale.as_str()]).find_map(Self::from_tag).unwrap_or_default()
    }

    pub(crate) fn identifier(self) -> LanguageIdentifier {
        self.tag().parse().unwrap_or_default()
    }

    /// The sign between the whole and the decimal digits.
    pub fn decimal_sign(self) -> char {
        match self {
            Language::English => '.',
            Language::German => ',',
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn environment(variables: &[(&str, &str)]) -> Language {
        Language::from_environment(|name| {
            variables.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn tags_and_locale_names() {
        for tag in ["de", "DE", "de-AT", "de_DE", "de_DE.UTF-8", "de@euro"] {
            assert_eq!(Language::from_tag(tag), Some(Language::German), "{tag}");
        }
        assert_eq!(Language::from_tag("en_GB.UTF-8"), Some(Language::English));
        for tag in ["", "fr", "deu", "d", "english"] {
            assert_eq!(Language::from_tag(tag), None, "{tag}");
        }
    }

    #[test]
    fn environment_by_the_rules_of_gettext() {
        use Language::{English, German};
        assert_eq!(environment(&[]), English);
        assert_eq!(environment(&[("LANG", "de_DE.UTF-8")]), German);
        assert_eq!(environment(&[("LANG", "de_DE"), ("LC_MESSAGES", "en_US")]), English);
        assert_eq!(environment(&[("LANG", "en_US"), ("LC_ALL", "de_AT.UTF-8")]), German);
        assert_eq!(environment(&[("LC_ALL", ""), ("LANG", "de_DE")]), German);
        assert_eq!(environment(&[("LANG", "en_US"), ("LANGUAGE", "fr:de:en")]), German);
        assert_eq!(environment(&[("LANG", "de_DE"), ("LANGUAGE", "")]), German);
        assert_eq!(environment(&[("LC_ALL", "C"), ("LANGUAGE", "de")]), English);
        assert_eq!(environment(&[("LC_ALL", "C.UTF-8"), ("LANG", "de_DE")]), English);
        assert_eq!(environment(&[("LANGUAGE", "de")]), English);
        assert_eq!(environment(&[("LANG", "fr_FR.UTF-8")]), English);
    }
}
