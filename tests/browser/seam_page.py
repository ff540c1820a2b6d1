"""The page of edit-seams in headless Chromium, used by mouse and keys as a person does."""
from browser import ActionChains, By, Keys, WebDriverWait, started_browser
from selenium.common.exceptions import NoAlertPresentException


class Page:
    """Its methods that click and press send events of mouse and keys. The others read what is shown."""

    def __init__(self):
        self.driver = started_browser()

    def close(self):
        self.driver.quit()

    def open(self, address):
        self.driver.get(address)
        self.wait(lambda: self.state("state") == "ready")

    def leave(self):
        self.driver.get("about:blank")

    def reload(self):
        self.driver.refresh()
        self.wait(lambda: self.state("state") == "ready")

    def script(self, text, *given):
        return self.driver.execute_script(text, *given)

    def state(self, name):
        return self.script("return document.documentElement.dataset[arguments[0]]", name)

    def wait(self, holds, seconds=20):
        WebDriverWait(self.driver, seconds, poll_frequency=0.05).until(lambda _: holds())

    def click_at(self, x, y):
        mouse = ActionChains(self.driver, duration=0)
        mouse.w3c_actions.pointer_action.move_to_location(round(x), round(y))
        mouse.w3c_actions.pointer_action.click()
        mouse.perform()

    def click_edge(self, panel, edge, share=0.5):
        """On the drawn edge, at a share of its length."""
        self.click_at(*self.script(
            """const path = document.querySelector(`[data-edge="${arguments[0]}"]`);
               const p = path.getPointAtLength(arguments[1] * path.getTotalLength());
               const at = p.matrixTransform(path.getScreenCTM());
               return [at.x, at.y];""", f"{panel}:{edge}", share))

    def click_panel(self, panel):
        """Inside of the panel, off its edges."""
        self.click_at(*self.script(
            """const box = document.querySelector(`[data-panel="${arguments[0]}"] .name`).getBoundingClientRect();
               return [(box.left + box.right) / 2, (box.top + box.bottom) / 2];""", panel))

    def click_beside(self):
        """In the corner of the sheet, where nothing is drawn."""
        self.click_at(*self.script(
            """const box = document.getElementById('sheet').getBoundingClientRect();
               return [box.left + 4, box.top + 4];"""))

    def sew(self, stitch):
        for side in stitch[:2]:
            self.click_edge(side["panel"], side["edge"])

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def press_control(self, key):
        ActionChains(self.driver).key_down(Keys.CONTROL).send_keys(key).key_up(
            Keys.CONTROL).perform()

    def click(self, name):
        self.driver.find_element(By.ID, name).click()

    def text(self, name):
        return self.driver.find_element(By.ID, name).text

    def seams(self):
        return int(self.state("seams"))

    def says(self):
        return self.text("progress")

    def busy(self, name="dress"):
        return not self.driver.find_element(By.ID, name).is_enabled()

    def arrows(self):
        """By edge, whether the arrow of its seam runs with it or against it."""
        return dict(self.script("return [...document.querySelectorAll('[data-arrow]')]"
                                ".map(a => [a.dataset.arrow, a.dataset.runs])"))

    def is_reversed(self, stitch):
        """As the arrows at both sides have it; None: there are none."""
        arrows = self.arrows()
        runs = [arrows.get(f"{side['panel']}:{side['edge']}") for side in stitch[:2]]
        return None if None in runs else runs[0] != runs[1]

    def warned_seams(self):
        """The row that each warning at a seam stands below, and the warning."""
        return self.script("""return [...document.querySelectorAll('#seams .warning')].map(line => {
            let row = line;
            while (!row.classList.contains('row')) row = row.previousElementSibling;
            return [row.textContent, line.textContent];
          });""")

    def question(self):
        """The page's question, or None."""
        try:
            return self.driver.switch_to.alert
        except NoAlertPresentException:
            return None

    def answer(self, yes):
        """Answers the question that comes, and returns its text."""
        self.wait(lambda: self.question() is not None)
        asked = self.question()
        text = asked.text
        if yes:
            asked.accept()
        else:
            asked.dismiss()
        return text

    def errors(self):
        """What the browser complains of, but for the answer that makes the page ask before it saves."""
        return [line for line in self.driver.get_log("browser")
                if line["level"] == "SEVERE" and "409 (Conflict)" not in line["message"]]
