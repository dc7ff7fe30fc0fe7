"""The page in a browser: what it shows, what can be done with it, and that it asks nobody for anything."""

import os
import re
import shutil

import pytest

DAY, NIGHT = "tiny/day_left-day_right@1f", "tiny/day_left-night_right@1f~miss"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SHOWN = "section.protocol:not([hidden])"


@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        pytest.skip(f"none of {', '.join(BROWSERS)} is installed")
    with playwright.sync_playwright() as driver:
        arguments = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
        one = driver.chromium.launch(executable_path=found, args=arguments)
        yield one
        one.close()


@pytest.fixture(scope="module")
def opened(browser, page_file):
    """Return a function that opens the page anew, and notes what must not happen in ``page.noted``."""
    contexts = []

    def open_page(ready=True, script="", **options):
        context = browser.new_context(**{"viewport": {"width": 1280, "height": 900}, **options})
        contexts.append(context)
        page = context.new_page()
        page.noted = []
        page.on("console", lambda message: page.noted.append(message.text))
        page.on("pageerror", lambda error: page.noted.append(str(error)))
        page.on("dialog", lambda dialog: page.noted.append(dialog.message) or dialog.dismiss())
        own = (page_file.as_uri(), "data:")
        page.on("request", lambda one: None if one.url.startswith(own) else page.noted.append(one.url))
        if script:
            page.add_init_script(script)
        page.goto(page_file.as_uri())
        if ready:
            page.wait_for_selector("html[data-ready]", state="attached")
        return page

    yield open_page
    for context in contexts:
        context.close()


@pytest.fixture(scope="module")
def desk(opened):
    """The page that most tests share; each leaves it as it found it."""
    return opened()


def methods(page):
    """Return the rows of the table in view by the beginning of their names, from top to bottom."""
    return [text.split()[0][:8] for text in page.locator(f"{SHOWN} .ranking tbody .name").all_inner_texts()]


def heading(page, column):
    return page.locator(f"{SHOWN} .ranking thead th", has_text=column).first


def sort_by(page, column, direction, press=None):
    """Sort by a column until it is sorted in that direction, as the table itself says."""
    for _ in range(2):
        before = heading(page, column).get_attribute("aria-sort")
        if before == direction:
            break
        heading(page, column).click() if press is None else heading(page, column).get_by_role("button").press(press)
        page.wait_for_function(
            "([head, before]) => head.getAttribute('aria-sort') !== before",
            arg=[heading(page, column).element_handle(), before],
        )
    assert heading(page, column).get_attribute("aria-sort") == direction


class TestOpening:
    def test_it_opens_without_a_fault_and_asks_nobody_for_anything(self, desk):
        for figure in desk.locator(f"{SHOWN} figure[data-chart]").all():
            figure.scroll_into_view_if_needed()
            figure.locator(".main-svg").first.wait_for()
        assert desk.noted == []

    def test_its_policy_forbids_to_ask(self, opened):
        page = opened()
        blocked = page.evaluate(
            """() => new Promise((resolve) => {
              document.addEventListener("securitypolicyviolation", (event) => resolve(event.blockedURI));
              new Image().src = "http://127.0.0.1:9/x.png";
            })"""
        )
        assert blocked == "http://127.0.0.1:9/x.png"

    def test_one_protocol_is_shown_and_the_simulated_one_is_named(self, desk):
        assert desk.locator(SHOWN).count() == 1
        assert desk.locator("nav .simulated h2").inner_text() == "Simulated images"
        assert desk.locator("nav .simulated a").inner_text().startswith("day_left → day_right")

    def test_a_hostile_name_is_text_everywhere(self, desk, hostile):
        start = hostile[:28]
        assert start in desk.locator(f"{SHOWN} .ranking").inner_text()
        assert start in desk.locator(f"{SHOWN} .methods").inner_text()
        assert start in desk.locator(f"{SHOWN} .gallery select").inner_text()
        hover = desk.evaluate(
            "CHART => document.querySelector(CHART).data.map((trace) => trace.name)", f"{SHOWN} .js-plotly-plot"
        )
        assert any(name.startswith("&lt;img src=x") for name in hover)
        assert desk.locator("img[src=x]").count() == 0

    def test_published_numbers_and_machines_are_text_too(self, desk):
        assert "<b>they</b>" in desk.locator(f"{SHOWN} .ranking").inner_text()
        assert "<u>chip 8</u>" in desk.locator("body > footer").inner_text()

    def test_a_very_long_name_is_cut_and_told_whole(self, desk, hostile):
        name = desk.locator(f"{SHOWN} .ranking .name", has_text="<img")
        whole = name.get_attribute("title")
        assert "x" * 300 in whole and whole.startswith(hostile[:28])
        assert "x" * 80 not in desk.locator(f"{SHOWN} .ranking").inner_text()
        assert "x" * 80 not in desk.locator(f"{SHOWN} .methods").inner_text()
        assert "x" * 80 not in desk.locator(f"{SHOWN} .gallery select").inner_text()
        assert "x" * 300 in desk.locator(f"{SHOWN} .origin").text_content()

    def test_an_interval_can_be_seen_beside_its_value(self, desk):
        sizes = """(whisker) => ["::before", "::after"].map((part) => {
          const style = getComputedStyle(whisker, part);
          return [parseFloat(style.width), parseFloat(style.height)];
        })"""
        for whisker in desk.locator(f"{SHOWN} .whisker").all():
            bar, mark = whisker.evaluate(sizes)
            assert bar[0] >= 2 * mark[0] and bar[1] >= 4


class TestTable:
    def test_what_has_no_place_is_last_and_partial_rows_are_blank(self, desk):
        assert methods(desk)[:2] == ["best", "<img"] and methods(desk)[-2:] == ["partial", "<b>they<"]
        assert desk.locator(f"{SHOWN} tr.unranked td.number").all_inner_texts()[:-1] == [""] * 7

    def test_it_is_sorted_by_mouse_and_by_keyboard(self, desk):
        first = methods(desk)
        sort_by(desk, "recall@1", "ascending")
        assert methods(desk)[:4] == first[:4][::-1] and methods(desk)[4:] == first[4:]
        sort_by(desk, "rank", "ascending", press="Enter")
        assert methods(desk) == first

    def test_blank_times_come_last_both_ways(self, desk):
        for direction in ("ascending", "descending"):
            sort_by(desk, "ms p50", direction)
            assert methods(desk)[3] == "busy"
        sort_by(desk, "rank", "ascending")

    def test_it_is_filtered_by_text_frames_and_machine(self, desk):
        everything = methods(desk)
        find = desk.locator(f"{SHOWN} input[type=search]")
        find.fill("SECO")
        assert methods(desk) == ["second"]
        assert desk.locator(f"{SHOWN} .count").inner_text() == "1 of 6 rows"
        find.fill("x" * 200)
        assert methods(desk) == ["<img"]
        find.fill("")
        desk.locator(f"{SHOWN} select[data-filter=frames]").select_option("several")
        assert methods(desk) == ["second"]
        desk.locator(f"{SHOWN} select[data-filter=frames]").select_option("")
        desk.locator(f"{SHOWN} select[data-filter=machine]").select_option("A")
        assert methods(desk) == ["busy"]
        desk.locator(f"{SHOWN} select[data-filter=machine]").select_option("")
        assert methods(desk) == everything


class TestChoosing:
    def test_another_protocol_is_shown_and_can_be_gone_back_from(self, desk):
        desk.locator("nav a", has_text="night_right").click()
        assert desk.locator(f"{SHOWN} h2").inner_text() == NIGHT
        assert methods(desk) == ["best", "second"]
        desk.go_back()
        assert desk.locator(f"{SHOWN} h2").inner_text() == DAY

    def test_a_theme_is_remembered_and_charts_follow_it(self, opened):
        page = opened(color_scheme="light")
        ink = "getComputedStyle(document.querySelector('.xtick text')).fill"
        light = page.evaluate(ink)
        page.locator("#theme").click()
        assert page.locator("html").get_attribute("data-theme") == "dark"
        page.wait_for_function(f"{ink} !== {light!r}")
        page.reload()
        assert page.locator("html").get_attribute("data-theme") == "dark"

    def test_a_method_is_taken_out_of_the_charts(self, desk):
        lines = "CHART => document.querySelector(CHART).data.length"
        before = desk.evaluate(lines, f"{SHOWN} .js-plotly-plot")
        button = desk.locator(f"{SHOWN} .methods button", has_text="second")
        button.click()
        assert desk.evaluate(lines, f"{SHOWN} .js-plotly-plot") == before - 1
        assert button.get_attribute("aria-pressed") == "false"
        button.click()
        assert desk.evaluate(lines, f"{SHOWN} .js-plotly-plot") == before

    def test_axes_stay_where_they_are_when_no_method_is_left(self, opened):
        page = opened()
        for figure in page.locator(f"{SHOWN} figure[data-chart]").all():
            figure.scroll_into_view_if_needed()
            figure.locator(".main-svg").first.wait_for()
        axes = f"""() => [...document.querySelectorAll("{SHOWN} .canvas")].map(
          (canvas) => [canvas._fullLayout.xaxis.range, canvas._fullLayout.xaxis.dtick])"""
        before = page.evaluate(axes)
        for button in page.locator(f"{SHOWN} .methods button").all():
            button.click()
        assert page.locator(f"{SHOWN} .scatterlayer .trace path.js-line[d]").count() == 0
        assert page.evaluate(axes) == before
        assert page.noted == []

    def test_lines_that_hide_each_other_are_named(self, opened):
        page = opened()
        radius = page.locator(f"{SHOWN} figure[data-chart=curves] select")
        said = page.locator(f"{SHOWN} figure[data-chart=curves] .alike")
        assert said.text_content() == ""
        radius.select_option(index=radius.locator("option").count() - 1)  # within which every answer is right
        assert re.fullmatch("One line for best, <img .*, busy and second\\.", said.text_content())

    def test_curves_at_another_radius_are_others(self, desk):
        recall = "CHART => document.querySelector(CHART).data[0].x.at(-1)"
        figure = desk.locator(f"{SHOWN} figure[data-chart=curves]")
        before = desk.evaluate(recall, f"{SHOWN} figure[data-chart=curves] .canvas")
        figure.locator("select").select_option("0")
        assert desk.evaluate(recall, f"{SHOWN} figure[data-chart=curves] .canvas") <= before
        figure.locator("select").select_option("1")
        assert desk.evaluate(recall, f"{SHOWN} figure[data-chart=curves] .canvas") == before


class TestGallery:
    def test_it_opens_by_mouse_goes_on_by_arrows_and_closes_by_escape(self, desk):
        cards = desk.locator(f"{SHOWN} .card")
        desk.locator(f"{SHOWN} .gallery").scroll_into_view_if_needed()
        cards.nth(0).click()
        title = desk.locator("#viewer h2")
        assert title.inner_text() == "best: failure 1 of 1"
        assert desk.locator("#viewer img").first.get_attribute("alt") == "Query: day_right/Image011.jpg"
        assert desk.evaluate("document.querySelector('#viewer img').naturalWidth") == 64
        desk.keyboard.press("ArrowRight")
        assert title.inner_text() == "best: success 1 of 3"
        desk.keyboard.press("Escape")
        assert not desk.locator("#viewer").is_visible()
        assert cards.nth(1).evaluate("card => card === document.activeElement")

    def test_it_opens_by_keyboard(self, desk):
        card = desk.locator(f"{SHOWN} .card").first
        card.focus()
        desk.keyboard.press("Enter")
        assert desk.locator("#viewer").is_visible()
        desk.locator("#viewer .close").click()
        assert card.evaluate("card => card === document.activeElement")

    def test_another_method_has_other_pictures(self, desk):
        chosen = desk.locator(f"{SHOWN} .gallery select")
        before = desk.locator(f"{SHOWN} .card").count()
        chosen.select_option(label="second")
        assert desk.locator(f"{SHOWN} .card").count() == 9 + 3 != before
        chosen.select_option(label="best")
        assert desk.locator(f"{SHOWN} .card").count() == before


class TestElsewhere:
    def test_a_telephone_need_not_be_scrolled_sideways(self, opened):
        page = opened(viewport={"width": 390, "height": 800}, has_touch=True, is_mobile=True)
        page.locator(f"{SHOWN} .gallery").scroll_into_view_if_needed()
        page.locator(f"{SHOWN} .card").first.wait_for()
        page.locator(f"{SHOWN} figure[data-chart=losses]").scroll_into_view_if_needed()
        key = page.locator(f"{SHOWN} .methods").bounding_box()
        assert 0 <= key["y"] < 10 and key["height"] < 160  # in view, and not in the way
        assert page.locator(f"{SHOWN} .sideways").is_visible()
        for details in page.locator(f"{SHOWN} details").all():
            details.evaluate("one => { one.open = true; }")
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        assert page.noted == []

    def test_without_javascript_there_are_plain_tables(self, opened):
        page = opened(ready=False, java_script_enabled=False)
        assert page.locator("table.ranking:visible").count() == 3
        assert page.locator("figure details:visible").count() > 0
        assert page.locator(".without-js").is_visible()
        assert page.locator(".canvas:visible, .gallery:visible, #theme:visible, .filters:visible").count() == 0

    def test_an_old_browser_is_told_so_and_has_plain_tables(self, opened):
        page = opened(ready=False, script="delete window.DecompressionStream")
        assert re.search("a browser of 2023 or later", page.locator(".without-js").inner_text())
        assert page.locator("table.ranking:visible").count() == 3
        assert page.noted == []
