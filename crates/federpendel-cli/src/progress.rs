//! A sign of life on standard error for whatever takes longer than a second.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::JoinHandle;
use std::time::Duration;

use federpendel_text::Catalogue;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that takes no longer shows nothing.
const PATIENCE: Duration = Duration::from_secs(1);

/// A progress bar that appears after a second and vanishes when dropped.
pub(crate) struct Progress {
    bar: ProgressBar,
    done: Option<Sender<()>>,
    waiter: Option<JoinHandle<()>>,
}

impl Progress {
    /// Computing in `steps` steps.
    pub(crate) fn computing(catalogue: &Catalogue, steps: u64) -> Self {
        Self::start(catalogue.text("cli-computing"), steps)
    }

    /// Writing files, in nobody knows how many steps.
    pub(crate) fn writing(catalogue: &Catalogue) -> Self {
        Self::start(catalogue.text("cli-writing"), 0)
    }

    /// Work that is known to be short.
    pub(crate) fn silent() -> Self {
        Self { bar: ProgressBar::hidden(), done: None, waiter: None }
    }

    fn start(message: String, steps: u64) -> Self {
        let length = (steps > 0).then_some(steps);
        let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::hidden());
        let template = if steps > 0 {
            "{spinner} {msg} {wide_bar} {percent} %"
        } else {
            "{spinner} {msg} {elapsed}"
        };
        // The templates are ours and well formed; the default style would do as well.
        bar.set_style(
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        bar.set_message(message);
        let (done, finished) = mpsc::channel();
        let shown = bar.clone();
        let waiter = std::thread::spawn(move || {
            if finished.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(Duration::from_millis(100));
            }
        });
        Self { bar, done: Some(done), waiter: Some(waiter) }
    }

    /// Says that `steps` more are done.
    pub(crate) fn advance(&self, steps: u64) {
        self.bar.inc(steps);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.done.take();
        if let Some(waiter) = self.waiter.take() {
            // A waiter that panicked has no bar to clear.
            let _ = waiter.join();
        }
        self.bar.finish_and_clear();
    }
}
