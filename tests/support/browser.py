"""Headless Chromium that draws without a graphics card, or exit code 77 where it is not installed."""
import shutil
import sys

SKIPPED = 77
try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ImportError:
    print("skipped: Selenium for Python is not installed (package python3-selenium)")
    sys.exit(SKIPPED)
for needed in ("chromium", "chromedriver"):
    if shutil.which(needed) is None:
        print(f"skipped: {needed} is not installed (packages chromium, chromium-driver)")
        sys.exit(SKIPPED)


def started_browser(logs=False):
    """logs: what scripts say can be read by get_log("browser")."""
    options = webdriver.ChromeOptions()
    for option in ("headless=new", "no-sandbox", "window-size=1500,950", "use-angle=swiftshader",
                   "enable-unsafe-swiftshader", "lang=en"):
        options.add_argument("--" + option)
    # The test answers the page's questions itself.
    options.set_capability("unhandledPromptBehavior", "ignore")
    if logs:
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options)
