//! Panics: those that end the program, and those that end one piece of work alone.

use std::{
    any::Any,
    cell::{Cell, RefCell},
    panic::{self, AssertUnwindSafe, PanicHookInfo},
    sync::{Arc, Mutex, Once, PoisonError},
    thread::{self, ThreadId},
};

use super::shared::Shared;

/// Runs code that may panic and hands the panic back as its message and place.
///
/// The terminal is not touched and nothing is printed. What `work` was changing may be half changed after an error;
/// throw it away. A stack overflow, `abort` and `exit` cannot be contained.
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    install_hook();
    let outer = CONTAINED.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    CONTAINED.set(outer);
    result.map_err(|payload| {
        let message = LAST.take().unwrap_or_else(|| text(&*payload));
        // The destructor of a payload can panic as well. A text cannot; anything else is leaked.
        if payload.downcast_ref::<String>().is_none() {
            std::mem::forget(payload);
        }
        message
    })
}

/// The session whose terminal a panic of this thread gives back.
pub(super) fn watch(shared: &Arc<Shared>) {
    install_hook();
    *SESSION.lock().unwrap_or_else(PoisonError::into_inner) = Some((thread::current().id(), shared.clone()));
}

/// No session has the terminal any more.
pub(super) fn forget() {
    *SESSION.lock().unwrap_or_else(PoisonError::into_inner) = None;
}

static SESSION: Mutex<Option<(ThreadId, Arc<Shared>)>> = Mutex::new(None);

thread_local! {
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
    static LAST: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// One hook for the whole process, in front of the one that was there.
fn install_hook() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| hook(info, &previous)));
    });
}

fn hook(info: &PanicHookInfo<'_>, previous: &dyn Fn(&PanicHookInfo<'_>)) {
    if CONTAINED.get() {
        LAST.set(Some(described(info)));
        return;
    }
    // The clone ends the borrow of the lock: the autosave may panic, and come here again.
    let session = SESSION.lock().unwrap_or_else(PoisonError::into_inner).clone();
    match session {
        Some((drawing, shared)) if thread::current().id() != drawing && shared.is_active() => {
            // The screen goes on; the thread is lost, and the user is reported.
            let name = thread::current().name().unwrap_or("of the background").to_owned();
            shared.notify(format!("a thread ({name}) ended by a fault of the program: {}", described(info)));
        }
        Some((_, shared)) => {
            shared.give_back();
            shared.save();
            previous(info);
        }
        None => previous(info),
    }
}

fn described(info: &PanicHookInfo<'_>) -> String {
    let message = text(info.payload());
    match info.location() {
        Some(place) => format!("{message} ({}:{})", place.file(), place.line()),
        None => message,
    }
}

fn text(payload: &(dyn Any + Send)) -> String {
    payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "a panic without a message".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contained_panic_is_named_with_its_place() {
        let error = catch_panic(|| -> u32 { panic!("row {} is empty", 3) }).unwrap_err();
        assert!(error.starts_with("row 3 is empty (") && error.contains("panics.rs:"), "{error}");
        assert_eq!(catch_panic(|| 7), Ok(7));
    }

    #[test]
    fn containment_nests() {
        let error = catch_panic(|| {
            assert!(catch_panic(|| panic!("inner")).is_err());
            panic!("outer")
        });
        let error: Result<(), String> = error;
        assert!(error.unwrap_err().starts_with("outer"));
    }

    #[test]
    fn a_payload_whose_destructor_panics_is_contained() {
        struct Trap;
        impl Drop for Trap {
            fn drop(&mut self) {
                panic!("in the destructor");
            }
        }
        let error: Result<(), String> = catch_panic(|| panic::panic_any(Trap));
        let error = error.unwrap_err();
        assert!(error.starts_with("a panic without a message"), "{error}");
    }
}
