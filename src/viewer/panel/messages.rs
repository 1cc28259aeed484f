//! What the user is told over the scene.

use core::time::Duration;

/// How long a message that asks for nothing stays.
const STAY: Duration = Duration::from_secs(6);

/// A message.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Message {
    /// What it is about; a new message replaces an older one about the same.
    pub(crate) about: &'static str,
    /// One sentence.
    pub(crate) title: String,
    /// More lines, shown as they are in letters of equal width; may be empty.
    pub(crate) detail: String,
    /// Whether something is wrong.
    pub(crate) is_error: bool,
    /// When it goes by itself, since the start of the program. Without it, it stays until mended or dismissed.
    pub(crate) until: Option<Duration>,
}

/// Messages, oldest first. There is no clock here: times are since the start of the program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Messages {
    list: Vec<Message>,
}

impl Messages {
    /// Tells something for a few seconds.
    pub(crate) fn tell(&mut self, about: &'static str, title: String, now: Duration) {
        let until = Some(now.saturating_add(STAY));
        self.add(Message { about, title, detail: String::new(), is_error: false, until });
    }

    /// Tells what is wrong, until it is [mended](Self::mend) or dismissed.
    pub(crate) fn complain(&mut self, about: &'static str, title: String, detail: String) {
        self.add(Message { about, title, detail, is_error: true, until: None });
    }

    fn add(&mut self, message: Message) {
        self.mend(message.about);
        self.list.push(message);
    }

    /// Takes away what was said about something.
    pub(crate) fn mend(&mut self, about: &'static str) {
        self.list.retain(|message| message.about != about);
    }

    /// Takes away one message.
    pub(crate) fn dismiss(&mut self, place: usize) {
        if place < self.list.len() {
            self.list.remove(place);
        }
    }

    /// Takes away the newest message; tells whether there was one.
    pub(crate) fn dismiss_newest(&mut self) -> bool {
        self.list.pop().is_some()
    }

    /// Takes away what has been there long enough, and tells when the next message goes.
    pub(crate) fn expire(&mut self, now: Duration) -> Option<Duration> {
        self.list.retain(|message| message.until.is_none_or(|until| now < until));
        self.list.iter().filter_map(|message| message.until).min()
    }

    /// All of them, oldest first.
    pub(crate) fn list(&self) -> &[Message] {
        &self.list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_told_goes_and_what_is_wrong_stays_until_mended() {
        let (mut messages, start) = (Messages::default(), Duration::from_secs(100));
        messages.tell("saved", "saved a.txt".to_owned(), start);
        messages.complain("scene", "b.txt is wrong".to_owned(), "line 3".to_owned());
        assert_eq!(messages.expire(start), Some(start + STAY));
        assert_eq!(messages.list().len(), 2);
        assert_eq!(messages.expire(start + STAY), None);
        assert_eq!(messages.list()[0].title, "b.txt is wrong");
        messages.complain("scene", "b.txt is still wrong".to_owned(), "line 4".to_owned());
        assert_eq!(messages.list().len(), 1);
        messages.mend("scene");
        assert!(messages.list().is_empty());
    }

    #[test]
    fn messages_are_dismissed_one_by_one() {
        let mut messages = Messages::default();
        for about in ["a", "b", "c"] {
            messages.complain(about, about.to_owned(), String::new());
        }
        messages.dismiss(0);
        messages.dismiss(7);
        assert!(messages.dismiss_newest());
        assert_eq!(messages.list()[0].about, "b");
        assert!(messages.dismiss_newest());
        assert!(!messages.dismiss_newest());
    }
}
