//! Which columns are read: for each run a time and a value.

use super::error::{Field, ReadError};
use super::heading::Heading;
use super::layout::Layout;
use super::meaning::{Fit, squeezed};
use super::size::Size;
use super::times::{TimeColumns, Times};
use super::unit::{self, Unit};
use super::{Choice, ColumnName};
use crate::Quantity;

/// The columns of one run.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Run {
    pub name: Option<String>,
    pub times: Times,
    /// The time has no header: it is the first column, which rises.
    pub time_guessed: bool,
    /// The header gives the time no unit: seconds.
    pub time_unit_assumed: bool,
    /// A column that the header calls a time, where a rate is asked for.
    pub time_ignored: Option<usize>,
    pub value: usize,
    pub unit: Option<Unit>,
    pub quantity: Quantity,
    /// Neither unit nor name say what is recorded: a position.
    pub quantity_assumed: bool,
    pub others: Vec<usize>,
}

/// Chooses columns. `sizes` holds what a sample says of each column.
pub(super) fn runs(
    layout: &Layout,
    sizes: &[Size],
    choice: &Choice,
) -> Result<Vec<Run>, ReadError> {
    let table = Table { headings: &layout.headings, sizes, layout, choice };
    let times = table.times()?;
    let groups = table.groups(&times);
    let wanted = table.wanted(groups)?;
    wanted.into_iter().map(|group| table.run(group, &times)).collect()
}

pub(super) struct Table<'a> {
    pub headings: &'a [Heading],
    pub sizes: &'a [Size],
    pub layout: &'a Layout,
    pub choice: &'a Choice,
}

/// Columns that belong together.
struct Group {
    name: Option<String>,
    time: Option<usize>,
    members: Vec<usize>,
}

impl Table<'_> {
    pub fn labels(&self) -> Vec<String> {
        self.headings.iter().map(|heading| heading.label.clone()).collect()
    }

    /// The columns that a name fits best; at least one.
    pub fn named(&self, field: Field, asked: &str) -> Result<Vec<usize>, ReadError> {
        let fits: Vec<Fit> =
            self.headings.iter().enumerate().map(|(at, h)| h.fits(asked, at)).collect();
        let best = fits.iter().min().copied().unwrap_or(Fit::No);
        if best == Fit::No {
            let (asked, columns) = (asked.to_owned(), self.labels());
            return Err(ReadError::ColumnNotFound { field, asked, columns });
        }
        Ok((0..fits.len()).filter(|at| fits[*at] == best).collect())
    }

    pub fn is_count(&self, at: usize) -> bool {
        self.layout.header && self.headings[at].is_count()
    }

    /// Groups columns by run; where no runs are named, each column of times begins a group.
    fn groups(&self, times: &TimeColumns) -> Vec<Group> {
        let mut groups: Vec<Group> = Vec::new();
        let by_run = self.headings.iter().any(|heading| heading.run.is_some());
        for (at, heading) in self.headings.iter().enumerate() {
            let is_time = times.columns.contains(&at);
            let place = match groups.len().checked_sub(1) {
                _ if by_run => groups.iter().position(|group| group.name == heading.run),
                last => last.filter(|last| !is_time || groups[*last].time.is_none()),
            };
            let place = place.unwrap_or_else(|| {
                let name = heading.run.clone();
                groups.push(Group { name, time: None, members: Vec::new() });
                groups.len() - 1
            });
            let group = &mut groups[place];
            match group.time {
                None if is_time => group.time = Some(at),
                _ => group.members.push(at),
            }
        }
        let shared = times.columns.first().copied();
        for group in &mut groups {
            group.time = group.time.or(shared);
        }
        let several = groups.len() > 1;
        let is_value = |at: &usize| !several || self.sizes[*at].is_numeric();
        groups.retain(|group| group.members.iter().any(is_value));
        if !by_run && groups.len() > 1 {
            for (at, group) in groups.iter_mut().enumerate() {
                group.name = Some((at + 1).to_string());
            }
        }
        groups
    }

    /// The run that is asked for, by its name or number, else all that hold what is asked for.
    fn wanted(&self, mut groups: Vec<Group>) -> Result<Vec<Group>, ReadError> {
        if groups.is_empty() {
            return Err(ReadError::NoValue { columns: self.labels() });
        }
        // Runs below each other are told by their times, later.
        let is_only = matches!(groups.as_slice(), [only] if only.name.is_none());
        if let Some(asked) = self.choice.run.as_ref().filter(|_| !is_only) {
            let number =
                |name: &str| -> String { name.chars().filter(char::is_ascii_digit).collect() };
            let fits = |exact: bool, group: &Group| {
                group.name.as_ref().is_some_and(|name| {
                    if exact {
                        squeezed(name) == squeezed(asked)
                    } else {
                        number(name) == asked.trim()
                    }
                })
            };
            let at = groups
                .iter()
                .position(|group| fits(true, group))
                .or_else(|| groups.iter().position(|group| fits(false, group)));
            let Some(at) = at else {
                let runs = groups.into_iter().filter_map(|group| group.name).collect();
                return Err(ReadError::RunNotFound { asked: asked.clone(), runs });
            };
            groups = vec![groups.swap_remove(at)];
        }
        if let Some(asked) = &self.choice.value {
            let named = self.named(Field::Value, asked)?;
            for group in &mut groups {
                let (members, others): (Vec<usize>, Vec<usize>) =
                    group.members.iter().partition(|at| named.contains(at));
                if members.len() > 1 {
                    let columns =
                        members.iter().map(|at| self.headings[*at].label.clone()).collect();
                    let (field, asked) = (Field::Value, asked.clone());
                    return Err(ReadError::ColumnAmbiguous { field, asked, columns });
                }
                group.members =
                    if members.is_empty() { Vec::new() } else { [members, others].concat() };
            }
            groups.retain(|group| !group.members.is_empty());
            if groups.is_empty() {
                let (field, asked, columns) = (Field::Value, asked.clone(), self.labels());
                return Err(ReadError::ColumnNotFound { field, asked, columns });
            }
        }
        Ok(groups)
    }

    fn run(&self, group: Group, times: &TimeColumns) -> Result<Run, ReadError> {
        let (value, others) = self.value(&group)?;
        let heading = &self.headings[value];
        let unit = self.unit(heading)?;
        let known = unit.and_then(|unit| unit.quantity).or_else(|| heading.quantity());
        if let (Some(asked), Some(unit)) = (self.choice.quantity, unit)
            && unit.quantity != Some(asked)
        {
            let column = heading.label.clone();
            let unit = self.choice.unit.clone().unwrap_or_else(|| heading.unit.clone());
            return Err(ReadError::QuantityUnit { column, unit, asked });
        }
        let (times_from, time_unit_assumed) = match (times.rate, group.time) {
            (None, Some(at)) => self.time_unit(at)?,
            (rate, _) => (Times::Rate(rate.unwrap_or(1.0)), false),
        };
        Ok(Run {
            name: group.name,
            times: times_from,
            time_guessed: times.guessed,
            time_unit_assumed,
            time_ignored: times.ignored,
            value,
            unit,
            quantity: self.choice.quantity.or(known).unwrap_or(Quantity::Position),
            quantity_assumed: self.choice.quantity.or(known).is_none(),
            others,
        })
    }

    /// The unit of the values: what was chosen, else what the heading says.
    fn unit(&self, heading: &Heading) -> Result<Option<Unit>, ReadError> {
        let of_values = |unit: &Unit| unit.quantity.is_some();
        let Some(asked) = &self.choice.unit else {
            return Ok(heading.known_unit().filter(of_values));
        };
        match unit::parse(asked).filter(of_values) {
            Some(unit) => Ok(Some(unit)),
            None => Err(ReadError::ValueUnit { asked: asked.clone() }),
        }
    }

    /// The column of values, and the others that could be it. Without a name: of the columns that hold the same as the
    /// first of them, the one with the largest oscillating part; never a magnitude.
    fn value(&self, group: &Group) -> Result<(usize, Vec<usize>), ReadError> {
        let measures = |at: &usize| {
            let heading = &self.headings[*at];
            Some(*at) != group.time
                && self.sizes[*at].is_numeric()
                && !(self.is_count(*at) || heading.is_magnitude() || heading.is_time())
        };
        if self.choice.value.is_some()
            && let [value, others @ ..] = group.members.as_slice()
        {
            return Ok((*value, others.iter().copied().filter(measures).collect()));
        }
        let all: Vec<usize> = group.members.iter().copied().filter(measures).collect();
        let asked = |at: &&usize| {
            self.choice.quantity.is_none_or(|asked| self.headings[**at].quantity() == Some(asked))
        };
        let Some(first) = all.iter().find(asked).or(all.first()) else {
            let garbled = self.garbled(group).map(|at| (at, Vec::new()));
            return garbled.ok_or_else(|| ReadError::NoValue { columns: self.labels() });
        };
        let kind = |at: usize| {
            let heading = &self.headings[at];
            let unit = heading.known_unit().map_or(heading.unit.as_str(), |unit| unit.si);
            (heading.quantity(), unit.to_owned())
        };
        let size = |at: usize| {
            let factor = self.headings[at].known_unit().map_or(1.0, |unit| unit.to_si(1.0));
            self.sizes[at].oscillation() * factor
        };
        let mut best = *first;
        for at in all.iter().copied().filter(|at| kind(*at) == kind(*first)) {
            if size(at) > size(best) {
                best = at;
            }
        }
        Ok((best, all.into_iter().filter(|at| *at != best).collect()))
    }

    /// A column of words that its heading says holds values: the first of them is refused with its line.
    fn garbled(&self, group: &Group) -> Option<usize> {
        let garbled = |at: &usize| {
            let heading = &self.headings[*at];
            Some(*at) != group.time
                && self.sizes[*at].has_texts()
                && !(self.is_count(*at) || heading.is_magnitude() || heading.is_time())
        };
        let named = |at: &usize| self.headings[*at].quantity().is_some();
        let all = || group.members.iter().copied().filter(garbled);
        all().find(named).or_else(|| all().next())
    }
}

/// What the public interface says of a column.
pub(super) fn name(layout: &Layout, at: usize) -> ColumnName {
    let Heading { label, name, unit, .. } = layout.headings[at].clone();
    ColumnName { label, name, unit, number: at + 1 }
}
